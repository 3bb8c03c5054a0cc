/* Prints all that is seen in a picture (binary PPM), every number to its last bit: the same on
 * every processor. exact_results part.aspect picture.ppm */
#include <aspect.h>
#include <stdio.h>
#include <stdlib.h>

static void print(const char* name, const double* values, size_t count) {
  printf("  %s", name);
  for (size_t i = 0; i < count; ++i) printf(" %a", values[i]);
  printf("\n");
}

int main(int argc, char** argv) {
  char message[ASPECT_MESSAGE_BYTES] = "give an index and a picture";
  aspect_source index = {argc == 3 ? argv[1] : "", NULL, 0};
  aspect_recogniser* recogniser = aspect_open(&index, 1, NULL, NULL, message);
  FILE* file = argc == 3 ? fopen(argv[2], "rb") : NULL;
  aspect_frame frame = {0};
  if (!recogniser || !file || fscanf(file, "P6 %d %d 255", &frame.width_px, &frame.height_px) != 2)
    return fprintf(stderr, "%s\n", message), 1;
  fgetc(file);
  size_t bytes = (size_t)frame.width_px * (size_t)frame.height_px * 3;
  unsigned char* pixels = malloc(bytes);
  if (!pixels || fread(pixels, 1, bytes, file) != bytes) return fputs("cut off\n", stderr), 1;
  frame.data = pixels;
  aspect_recognition seen;
  if (aspect_recognise(recogniser, &frame, &seen) != ASPECT_OK) return 1;
  for (size_t i = 0; i < seen.contour_count; ++i) {
    const aspect_contour* contour = &seen.contours[i];
    const double values[] = {contour->centre_x_px, contour->centre_y_px, contour->area_px,
                             contour->mean_rgb[0], contour->mean_rgb[1], contour->mean_rgb[2]};
    print("contour", values, 6);
  }
  for (size_t i = 0; i < seen.object_count; ++i) {
    const aspect_object* object = &seen.objects[i];
    printf("%s\n", aspect_verdict_name(object->verdict));
    print("probability", &object->probability, 1);
    for (size_t h = 0; h < object->hypothesis_count; ++h) {
      const aspect_hypothesis* hypothesis = &object->hypotheses[h];
      printf(" %s class %d\n", hypothesis->object, hypothesis->class_id);
      print("score", &hypothesis->score, 1);
      if (!hypothesis->pose) continue;
      print("quaternion", hypothesis->pose->quaternion, 4);
      print("translation", hypothesis->pose->translation, 3);
      print("covariance", hypothesis->pose->covariance, 36);
    }
  }
  aspect_close(recogniser);
  return free(pixels), fclose(file);
}
