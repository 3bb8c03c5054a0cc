// As the C example, from C++.
#include <aspect.h>

#include <cstdio>
#include <fstream>
#include <iterator>
#include <memory>
#include <string>
#include <vector>

int main(int, char** arguments) {
  const aspect_source source{arguments[1], nullptr, 0};
  const std::unique_ptr<aspect_recogniser, void (*)(aspect_recogniser*)> recogniser(
      aspect_open(&source, 1, nullptr, nullptr, nullptr), aspect_close);
  std::ifstream file(arguments[2], std::ios::binary);
  std::string magic;
  int most = 0;
  aspect_frame frame{};
  file >> magic >> frame.width_px >> frame.height_px >> most;
  file.get();
  const std::vector<char> pixels{std::istreambuf_iterator<char>(file), {}};
  frame.data = pixels.data();
  aspect_recognition seen;
  if (aspect_recognise(recogniser.get(), &frame, &seen) != ASPECT_OK) return 1;
  for (std::size_t i = 0; i < seen.object_count; ++i) {
    const aspect_hypothesis& first = seen.objects[i].hypotheses[0];
    std::printf("%s %.3f at %.3f %.3f %.3f\n", first.object, seen.objects[i].probability,
                first.pose->translation[0], first.pose->translation[1], first.pose->translation[2]);
  }
}
