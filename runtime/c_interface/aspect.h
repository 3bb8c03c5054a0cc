/* Aspect: names the object, the aspect seen and its pose in a colour frame, by class indexes that
 * aspectc compiled from CAD models.
 *
 *   char message[ASPECT_MESSAGE_BYTES];
 *   aspect_source part = {"part.aspect", NULL, 0};
 *   aspect_recogniser* recogniser = aspect_open(&part, 1, NULL, NULL, message);
 *   aspect_frame frame = {pixels, 640, 480, 0, ASPECT_RGB8};
 *   aspect_recognition seen;
 *   if (aspect_recognise(recogniser, &frame, &seen) == ASPECT_OK) ...
 *   aspect_close(recogniser);
 *
 * Threads: any number of recognisers may be used at the same time, each of them by one thread at a
 * time. Nothing is global: no state, no signal handler, no output, no thread of its own.
 * Memory: what a function returns or fills in belongs to the recogniser. After the first frame of a
 * size nothing is allocated.
 * Versions: a program that was linked with libaspect.so.N runs with each later libaspect.so.N.
 * ASPECT_API_VERSION rises with every function or constant that is added.
 */
#ifndef ASPECT_H
#define ASPECT_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#if defined(__GNUC__)
#define ASPECT_API __attribute__((visibility("default")))
#else
#define ASPECT_API
#endif

#define ASPECT_API_VERSION 1

/* ASPECT_API_VERSION of the library, which may be newer than this header. */
ASPECT_API int aspect_api_version(void);
/* As "0.1.0". */
ASPECT_API const char* aspect_version(void);

typedef enum aspect_status {
  ASPECT_OK = 0,
  ASPECT_BAD_ARGUMENT = 1, /* a null pointer, no pixels, or rows shorter than their pixels */
  ASPECT_WRONG_SIZE = 2,   /* sides of 1 to 8192 pixels, 16 million in all, even where pixels are in
                              pairs */
  ASPECT_WRONG_FORMAT =
      3, /* not a format, or of another sensor than the indexes were compiled for */
  ASPECT_NO_MEMORY = 4
} aspect_status;

/* One line in English, without its line feed. */
ASPECT_API const char* aspect_status_text(aspect_status status);

/* ---- Opening ---- */

/* A class index, or a bundle of them. */
typedef struct aspect_source {
  const char* name;  /* the file; where there are bytes, what messages call them */
  const void* bytes; /* its content, of which a copy is made; NULL: the file is read */
  size_t byte_count;
} aspect_source;

typedef struct aspect_recogniser aspect_recogniser;

#define ASPECT_MESSAGE_BYTES 1024

/* Loads, checks and tests indexes of one sensor, each of another object.
 *
 * configuration_file: TOML with [camera], [segmentation] and [recognition] as aspect-replay and
 * aspectd read it; indexes that it names come after `sources`. configuration: TOML text, whose
 * values win, as "recognition.track = true\nrecognition.top = 3". Both may be NULL. Every key is
 * explained by `aspectd --help`.
 *
 * NULL where something is wrong; then `message`, of ASPECT_MESSAGE_BYTES or NULL, says in one line
 * which file or key, what is wrong with it and what to do. Takes milliseconds an index. */
ASPECT_API aspect_recogniser* aspect_open(const aspect_source* sources, size_t source_count,
                                          const char* configuration_file, const char* configuration,
                                          char* message);

/* NULL is closed already. */
ASPECT_API void aspect_close(aspect_recogniser* recogniser);

/* The n-th line about what was opened and may not be meant so, NULL beyond the last one. */
ASPECT_API const char* aspect_warning(const aspect_recogniser* recogniser, size_t n);

/* An object that is known. */
typedef struct aspect_known_object {
  const char* object; /* its name */
  size_t class_count; /* aspects that are told apart */
  /* In the scene's units and coordinates; all 0 where the index does not say. */
  double diameter;          /* largest distance between two points of its surface */
  double least[3], most[3]; /* corners of its box */
  double centre[3];         /* that views look at */
} aspect_known_object;

ASPECT_API size_t aspect_known_object_count(const aspect_recogniser* recogniser);
/* ASPECT_BAD_ARGUMENT where there is none. */
ASPECT_API aspect_status aspect_known_object_at(const aspect_recogniser* recogniser, size_t n,
                                                aspect_known_object* known);

/* ---- A frame ---- */

typedef enum aspect_format {
  ASPECT_RGB8 = 0, /* 8 bits a channel, interleaved */
  ASPECT_BGR8 = 1,
  ASPECT_RGBX8 = 2, /* 32 bits a pixel, the fourth byte is not looked at */
  ASPECT_BGRX8 = 3,
  ASPECT_GREY8 = 4,
  ASPECT_DEPTH16 = 5, /* distance along the camera's axis; 0 and 65535: nothing measured */
  ASPECT_LABEL16 = 6, /* number of the surface seen, 0: none */
  ASPECT_YUYV8 = 7,   /* 4:2:2, two pixels as Y U Y V */
  ASPECT_UYVY8 = 8,
  ASPECT_NV12 = 9, /* 4:2:0, a plane of Y, then one of U V pairs with half as many rows */
  ASPECT_NV21 = 10,
  ASPECT_BAYER_RGGB8 = 11, /* the first two pixels of the first two rows */
  ASPECT_BAYER_GRBG8 = 12,
  ASPECT_BAYER_GBRG8 = 13,
  ASPECT_BAYER_BGGR8 = 14
} aspect_format;

typedef enum aspect_yuv_matrix {
  ASPECT_BT601 = 0,
  ASPECT_BT709 = 1,
  ASPECT_BT2020 = 2
} aspect_yuv_matrix;

/* Set it to zeros before you fill it in. Pixels are read in place, and not kept. */
typedef struct aspect_frame {
  const void* data;
  int width_px, height_px;
  ptrdiff_t stride_bytes; /* from one row to the next, below 0 where rows go up; 0: no gap */
  aspect_format format;
  const void* chroma;            /* second plane of NV12 and NV21; NULL: right behind the first */
  ptrdiff_t chroma_stride_bytes; /* 0: as the first plane's */
  aspect_yuv_matrix yuv_matrix;
  int yuv_full_range; /* not 0: Y of 0 to 255 in place of 16 to 235 */
  int missed;         /* frames of the camera since the last one given, for tracking */
} aspect_frame;

/* ---- What was seen ---- */

/* Pixels [x, x + width) x [y, y + height). */
typedef struct aspect_box {
  int x, y, width, height;
} aspect_box;

/* Takes object coordinates to the camera's: x right, y down, z forward, in the scene's units. */
typedef struct aspect_pose {
  double quaternion[4]; /* w x y z */
  double translation[3];
  double reprojection_px; /* root mean square of the borders' distances */
  double covariance[36];  /* of three turns about the camera's axes in radians and of the place, row
                             by row */
} aspect_pose;

typedef enum aspect_verdict {
  ASPECT_NO_VERDICT = 0, /* no pose was looked for, so nothing can be said */
  ASPECT_MATCH = 1,      /* the first hypothesis's object */
  ASPECT_AMBIGUOUS = 2,  /* the rivals explain the picture as well */
  ASPECT_UNKNOWN = 3     /* nothing that is known */
} aspect_verdict;

/* "match" and so on; "" for ASPECT_NO_VERDICT. */
ASPECT_API const char* aspect_verdict_name(aspect_verdict verdict);

typedef struct aspect_contour_match {
  uint16_t contour; /* of the frame: place in aspect_recognition.contours */
  uint16_t name;    /* of the class: 0 is A, 25 Z, 26 AA */
} aspect_contour_match;

typedef struct aspect_hypothesis {
  const char* object;
  size_t known_object; /* for aspect_known_object_at and aspect_recognition.cameras */
  int class_id;
  double score;            /* what the list is ordered by */
  int matched, unmatched;  /* of the frame's contours */
  double view[3];          /* unit vector from the object's centre to the camera */
  const aspect_pose* pose; /* NULL: none was found */
  const aspect_contour_match* contours;
  size_t contour_count;
} aspect_hypothesis;

typedef struct aspect_object {
  aspect_box box;
  int regions;
  aspect_verdict verdict;
  double probability;
  const aspect_hypothesis* hypotheses; /* best first */
  size_t hypothesis_count;
  const uint8_t* rivals; /* places of hypotheses that explain the picture as well as the first */
  size_t rival_count;
  uint32_t track; /* its number from frame to frame, 0: none */
} aspect_object;

/* The border of a region of one colour, or of a hole in it. */
typedef struct aspect_contour {
  aspect_box box;
  float centre_x_px, centre_y_px;
  float area_px;
  float mean_rgb[3]; /* 0 to 255 */
  int is_hole;
  /* Freeman chain: border pixels from the start on, one step a code, 0 = +x, then every 45 degrees
   * towards +y. */
  int start_x, start_y;
  const uint8_t* chain;
  size_t chain_length;
} aspect_contour;

/* A pinhole with OpenCV's lens model; pixel centres are at whole numbers. */
typedef struct aspect_camera {
  double fx_px, fy_px, cx_px, cy_px;
  double k1, k2, p1, p2, k3;
} aspect_camera;

/* What a time limit left no time for; all 0: nothing was left undone. */
typedef struct aspect_left_undone {
  int objects;  /* that stand alone and were not looked at to their end */
  int indexes;  /* whose objects were not looked for before any background */
  int starts;   /* places where one of those may be */
  int tracks;   /* followed objects that were not looked for */
  int searches; /* 1: all of the frame should have been searched */
} aspect_left_undone;

typedef struct aspect_recognition {
  const aspect_object* objects; /* those alone, largest first, then the others, best first, then
                                   those that are followed */
  size_t object_count;
  const aspect_contour* contours; /* all that was seen; none in a frame that was only followed */
  size_t contour_count;
  const aspect_camera* cameras; /* that each known object was looked for with */
  size_t camera_count;
  int dropped_regions; /* seen, but too many: the smallest ones */
  double elapsed_ms;
  aspect_left_undone left_undone;
} aspect_recognition;

/* Fills in `recognition`, which is good until the recogniser's next call. Where the status is not
 * ASPECT_OK it has no objects. */
ASPECT_API aspect_status aspect_recognise(aspect_recogniser* recogniser, const aspect_frame* frame,
                                          aspect_recognition* recognition);

#ifdef __cplusplus
}
#endif

#endif
