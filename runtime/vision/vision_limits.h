// Capacities of the per-frame path. Going over one degrades: the smallest or the lowest are
// dropped and counted in ViewGraph::dropped_regions.
#pragma once

namespace aspect {

inline constexpr int kMinFrameSide_px = 4;  // of recorded frames
inline constexpr int kMaxFrameSide_px = 8192;
inline constexpr int kMaxFramePixels = 16'000'000;     // of recorded frames
inline constexpr int kMaxRegions = 1024;               // kept regions of a frame
inline constexpr int kMaxBlobs = 64;                   // blobs of a frame
inline constexpr int kMaxBlobContours = 48;            // contours of a blob
inline constexpr int kMaxRelations = 16 * 1024;        // of a frame
inline constexpr int kRunsPerPixelDivisor = 8;         // runs: an eighth of the pixels
inline constexpr int kRegionRunsPerPixelDivisor = 12;  // of regions, once small ones have grown
inline constexpr int kWaitingRunsDivisor = 6;          // runs between cores: a sixth of the pixels

}  // namespace aspect
