/* Prints what is seen in a picture (binary PPM): recognise part.aspect picture.ppm */
#include <aspect.h>
#include <stdio.h>
#include <stdlib.h>

int main(int argc, char** argv) {
  char message[ASPECT_MESSAGE_BYTES];
  aspect_source index = {argc == 3 ? argv[1] : "", NULL, 0};
  aspect_recogniser* recogniser = aspect_open(&index, 1, NULL, NULL, message);
  FILE* file = argc == 3 ? fopen(argv[2], "rb") : NULL;
  aspect_frame frame = {0}; /* tightly packed ASPECT_RGB8 */
  if (!recogniser || !file || fscanf(file, "P6 %d %d 255", &frame.width_px, &frame.height_px) != 2)
    return fprintf(stderr, "%s\n", recogniser ? "give an index and a PPM" : message), 1;
  fgetc(file); /* the one space before the pixels */
  size_t bytes = (size_t)frame.width_px * (size_t)frame.height_px * 3;
  unsigned char* pixels = malloc(bytes);
  if (!pixels || fread(pixels, 1, bytes, file) != bytes) return fputs("cut off\n", stderr), 1;
  frame.data = pixels;

  aspect_recognition seen;
  aspect_status status = aspect_recognise(recogniser, &frame, &seen);
  if (status != ASPECT_OK) return fprintf(stderr, "%s\n", aspect_status_text(status)), 1;
  for (size_t i = 0; i < seen.object_count; ++i) {
    const aspect_object* object = &seen.objects[i];
    if (object->verdict != ASPECT_MATCH) continue;
    const aspect_pose* pose = object->hypotheses[0].pose;
    printf("%s %.3f at %.3f %.3f %.3f\n", object->hypotheses[0].object, object->probability,
           pose->translation[0], pose->translation[1], pose->translation[2]);
  }
  aspect_close(recogniser);
  return free(pixels), fclose(file);
}
