// What a frame's time limit left no time for. All 0: nothing was left undone.
#pragma once

namespace aspect {

struct LeftUndone {
  int objects = 0;   // pieces of foreground that were not looked at to their end
  int indexes = 0;   // whose objects were not looked for before any background
  int starts = 0;    // places where one of those may be that were not drawn or not refined
  int tracks = 0;    // followed objects that were not looked for
  int searches = 0;  // 1: all of the frame would have been searched, of which a part was looked at

  bool any() const { return objects + indexes + starts + tracks + searches > 0; }
};

}  // namespace aspect
