// The module aspect._native: aspect.h as Python objects. What is for people (options, files, the
// compiler) is in aspect/__init__.py.
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <array>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "runtime/python_interface/array_frame.h"
#include "runtime/python_interface/kept_recognition.h"

namespace py = pybind11;

namespace aspect {
namespace {

// Becomes aspect.Error.
struct Failure : std::runtime_error {
  using std::runtime_error::runtime_error;
};

using Kept = std::shared_ptr<const KeptRecognition>;

// A part of what was seen, with all of it.
template <typename Plain>
struct Seen {
  Kept kept;
  const Plain* plain;
  const Plain* operator->() const { return plain; }
};
using Object = Seen<aspect_object>;
using Hypothesis = Seen<aspect_hypothesis>;
using Pose = Seen<aspect_pose>;
using Contour = Seen<aspect_contour>;

template <typename Plain>
std::vector<Seen<Plain>> all_of(const Kept& kept, const Plain* first, std::size_t count) {
  std::vector<Seen<Plain>> all;
  all.reserve(count);
  for (std::size_t k = 0; k < count; ++k) all.push_back({kept, first + k});
  return all;
}

template <std::size_t kCount>
py::array_t<double> array_of(const double (&numbers)[kCount]) {
  return py::array_t<double>(static_cast<py::ssize_t>(kCount), numbers);
}

py::tuple tuple_of(const aspect_box& box) {
  return py::make_tuple(box.x, box.y, box.width, box.height);
}

// Object to camera coordinates, of points as columns with a 1.
py::array_t<double> matrix_of(const aspect_pose& pose) {
  const auto [w, x, y, z] = pose.quaternion;
  py::array_t<double> matrix({4, 4});
  const std::array<double, 16> rows = {1 - 2 * (y * y + z * z),
                                       2 * (x * y - w * z),
                                       2 * (x * z + w * y),
                                       pose.translation[0],
                                       2 * (x * y + w * z),
                                       1 - 2 * (x * x + z * z),
                                       2 * (y * z - w * x),
                                       pose.translation[1],
                                       2 * (x * z - w * y),
                                       2 * (y * z + w * x),
                                       1 - 2 * (x * x + y * y),
                                       pose.translation[2],
                                       0,
                                       0,
                                       0,
                                       1};
  std::copy(rows.begin(), rows.end(), matrix.mutable_data());
  return matrix;
}

// 0 is A, 25 Z, 26 AA.
std::string contour_name(std::uint16_t place) {
  std::string name;
  for (unsigned rest = place + 1U; rest > 0; rest = (rest - 1) / 26)
    name.insert(name.begin(), static_cast<char>('A' + (rest - 1) % 26));
  return name;
}

py::list named_contours(const aspect_hypothesis& hypothesis) {
  py::list list;
  for (std::size_t k = 0; k < hypothesis.contour_count; ++k)
    list.append(
        py::make_tuple(hypothesis.contours[k].contour, contour_name(hypothesis.contours[k].name)));
  return list;
}

// The border's pixels, N x 2.
py::array_t<int> points_of(const aspect_contour& contour) {
  constexpr std::array<int, 8> kRight = {1, 1, 0, -1, -1, -1, 0, 1},
                               kDown = {0, 1, 1, 1, 0, -1, -1, -1};
  py::array_t<int> points(
      {static_cast<py::ssize_t>(std::max<std::size_t>(1, contour.chain_length)), py::ssize_t{2}});
  int* out = points.mutable_data();
  int x = contour.start_x, y = contour.start_y;
  *out++ = x;
  *out++ = y;
  // The last step leads back to the start.
  for (std::size_t k = 0; k + 1 < contour.chain_length; ++k) {
    x += kRight[contour.chain[k] & 7U];
    y += kDown[contour.chain[k] & 7U];
    *out++ = x;
    *out++ = y;
  }
  return points;
}

bool is_named(const aspect_object& object) {
  return object.verdict != ASPECT_UNKNOWN && object.hypothesis_count > 0;
}

std::optional<Pose> pose_of(const Kept& kept, const aspect_hypothesis& hypothesis) {
  if (hypothesis.pose == nullptr) return std::nullopt;
  return Pose{kept, hypothesis.pose};
}

class Recogniser {
 public:
  // Of each source a name and its bytes, or None for a file.
  Recogniser(const std::vector<std::pair<std::string, std::optional<py::bytes>>>& sources,
             const std::optional<std::string>& configuration_file, const std::string& configuration,
             std::string colour_format)
      : colour_format_(std::move(colour_format)) {
    std::vector<aspect_source> plain;
    for (const auto& [name, bytes] : sources) {
      aspect_source source{name.c_str(), nullptr, 0};
      if (bytes) {
        char* data = nullptr;
        py::ssize_t size = 0;
        PyBytes_AsStringAndSize(bytes->ptr(), &data, &size);
        source.bytes = data;
        source.byte_count = static_cast<std::size_t>(size);
      }
      plain.push_back(source);
    }
    char message[ASPECT_MESSAGE_BYTES];
    {
      const py::gil_scoped_release released;
      opened_.reset(aspect_open(plain.data(), plain.size(),
                                configuration_file ? configuration_file->c_str() : nullptr,
                                configuration.c_str(), message),
                    aspect_close);
    }
    if (!opened_) throw Failure(message);
  }

  Kept recognise(const py::array& pixels, const std::string& format, int missed) {
    aspect_frame frame = array_frame(pixels, format, colour_format_);
    frame.missed = missed;
    // Others may run meanwhile; a second call waits.
    const py::gil_scoped_release released;
    const std::lock_guard lock(*mutex_);
    aspect_recognition seen;
    aspect_status status = aspect_recognise(opened_.get(), &frame, &seen);
    // Two dimensions of 16 bits are either.
    if (status == ASPECT_WRONG_FORMAT && format.empty() && frame.format == ASPECT_DEPTH16) {
      frame.format = ASPECT_LABEL16;
      status = aspect_recognise(opened_.get(), &frame, &seen);
    }
    if (status != ASPECT_OK) throw Failure(aspect_status_text(status));
    return std::make_shared<const KeptRecognition>(seen, opened_);
  }

  std::vector<std::string> warnings() const {
    std::vector<std::string> lines;
    for (std::size_t n = 0; const char* line = aspect_warning(opened_.get(), n); ++n)
      lines.emplace_back(line);
    return lines;
  }

  std::vector<aspect_known_object> objects() const {
    std::vector<aspect_known_object> all(aspect_known_object_count(opened_.get()));
    for (std::size_t n = 0; n < all.size(); ++n) aspect_known_object_at(opened_.get(), n, &all[n]);
    return all;
  }

 private:
  std::shared_ptr<aspect_recogniser> opened_;
  std::unique_ptr<std::mutex> mutex_ = std::make_unique<std::mutex>();
  std::string colour_format_;
};

aspect_camera camera_of(const Kept& kept, const Object& object) {
  if (object->hypothesis_count == 0) throw py::value_error("nothing that is known is like it");
  return kept->cameras.at(object->hypotheses[0].known_object);
}

void define_pose(py::module_& module) {
  py::class_<Pose>(module, "Pose")
      .def_property_readonly("matrix", [](const Pose& p) { return matrix_of(*p.plain); })
      .def_property_readonly("quaternion", [](const Pose& p) { return array_of(p->quaternion); })
      .def_property_readonly("translation", [](const Pose& p) { return array_of(p->translation); })
      .def_property_readonly("reprojection_px", [](const Pose& p) { return p->reprojection_px; })
      .def_property_readonly("covariance", [](const Pose& p) {
        return array_of(p->covariance).reshape({6, 6});
      });
}

void define_hypothesis(py::module_& module) {
  py::class_<Hypothesis>(module, "Hypothesis")
      .def_property_readonly("object", [](const Hypothesis& h) { return h->object; })
      .def_property_readonly("class_id", [](const Hypothesis& h) { return h->class_id; })
      .def_property_readonly("score", [](const Hypothesis& h) { return h->score; })
      .def_property_readonly("matched", [](const Hypothesis& h) { return h->matched; })
      .def_property_readonly("unmatched", [](const Hypothesis& h) { return h->unmatched; })
      .def_property_readonly("view", [](const Hypothesis& h) { return array_of(h->view); })
      .def_property_readonly("pose", [](const Hypothesis& h) { return pose_of(h.kept, *h.plain); })
      .def_property_readonly("contours",
                             [](const Hypothesis& h) { return named_contours(*h.plain); });
}

void define_object(py::module_& module) {
  py::class_<Object>(module, "Object")
      .def_property_readonly("object",
                             [](const Object& o) {
                               return is_named(*o.plain)
                                          ? std::optional<std::string>(o->hypotheses[0].object)
                                          : std::nullopt;
                             })
      .def_property_readonly("verdict",
                             [](const Object& o) { return aspect_verdict_name(o->verdict); })
      .def_property_readonly("probability", [](const Object& o) { return o->probability; })
      .def_property_readonly("box", [](const Object& o) { return tuple_of(o->box); })
      .def_property_readonly("regions", [](const Object& o) { return o->regions; })
      .def_property_readonly("track",
                             [](const Object& o) {
                               return o->track > 0 ? std::optional<std::uint32_t>(o->track)
                                                   : std::nullopt;
                             })
      .def_property_readonly("pose",
                             [](const Object& o) -> std::optional<py::array_t<double>> {
                               if (!is_named(*o.plain) || o->hypotheses[0].pose == nullptr)
                                 return std::nullopt;
                               return matrix_of(*o->hypotheses[0].pose);
                             })
      .def_property_readonly("contours",
                             [](const Object& o) {
                               return is_named(*o.plain) ? named_contours(o->hypotheses[0])
                                                         : py::list();
                             })
      .def_property_readonly(
          "hypotheses",
          [](const Object& o) { return all_of(o.kept, o->hypotheses, o->hypothesis_count); })
      .def_property_readonly("rivals", [](const Object& o) {
        std::vector<Hypothesis> rivals;
        for (std::size_t k = 0; k < o->rival_count; ++k)
          if (o->rivals[k] < o->hypothesis_count)
            rivals.push_back({o.kept, o->hypotheses + o->rivals[k]});
        return rivals;
      });
}

void define_contour(py::module_& module) {
  py::class_<Contour>(module, "Contour")
      .def_property_readonly("box", [](const Contour& c) { return tuple_of(c->box); })
      .def_property_readonly(
          "centre_px",
          [](const Contour& c) { return py::make_tuple(c->centre_x_px, c->centre_y_px); })
      .def_property_readonly("area_px", [](const Contour& c) { return c->area_px; })
      .def_property_readonly("mean_rgb",
                             [](const Contour& c) {
                               return py::make_tuple(c->mean_rgb[0], c->mean_rgb[1],
                                                     c->mean_rgb[2]);
                             })
      .def_property_readonly("is_hole", [](const Contour& c) { return c->is_hole != 0; })
      .def_property_readonly("points", [](const Contour& c) { return points_of(*c.plain); });
}

void define_recognition(py::module_& module) {
  py::class_<KeptRecognition, std::shared_ptr<KeptRecognition>>(module, "Recognition")
      .def("__len__", [](const KeptRecognition& r) { return r.objects.size(); })
      .def("__getitem__",
           [](const Kept& r, py::ssize_t place) {
             const auto count = static_cast<py::ssize_t>(r->objects.size());
             const py::ssize_t n = place < 0 ? place + count : place;
             if (n < 0 || n >= count) throw py::index_error("no such object");
             return Object{r, &r->objects[static_cast<std::size_t>(n)]};
           })
      .def_property_readonly(
          "objects", [](const Kept& r) { return all_of(r, r->objects.data(), r->objects.size()); })
      .def_property_readonly(
          "contours",
          [](const Kept& r) { return all_of(r, r->contours.data(), r->contours.size()); })
      .def_property_readonly("dropped_regions",
                             [](const KeptRecognition& r) { return r.dropped_regions; })
      .def_property_readonly("elapsed_ms", [](const KeptRecognition& r) { return r.elapsed_ms; })
      .def_property_readonly("left_undone",
                             [](const KeptRecognition& r) {
                               const aspect_left_undone& left = r.left_undone;
                               py::dict counts;
                               const auto put = [&](const char* name, int count) {
                                 if (count > 0) counts[name] = count;
                               };
                               put("objects", left.objects);
                               put("indexes", left.indexes);
                               put("starts", left.starts);
                               put("tracks", left.tracks);
                               put("searches", left.searches);
                               return counts;
                             })
      .def("camera_matrix",
           [](const Kept& r, const Object& object) {
             const aspect_camera c = camera_of(r, object);
             const double rows[9] = {c.fx_px, 0, c.cx_px, 0, c.fy_px, c.cy_px, 0, 0, 1};
             return array_of(rows).reshape({3, 3});
           })
      .def("distortion", [](const Kept& r, const Object& object) {
        const aspect_camera c = camera_of(r, object);
        const double numbers[5] = {c.k1, c.k2, c.p1, c.p2, c.k3};
        return array_of(numbers);
      });
}

void define_known_object(py::module_& module) {
  using Known = aspect_known_object;
  py::class_<Known>(module, "KnownObject")
      .def_property_readonly("object", [](const Known& k) { return k.object; })
      .def_property_readonly("class_count", [](const Known& k) { return k.class_count; })
      .def_property_readonly("diameter", [](const Known& k) { return k.diameter; })
      .def_property_readonly("least", [](const Known& k) { return array_of(k.least); })
      .def_property_readonly("most", [](const Known& k) { return array_of(k.most); })
      .def_property_readonly("centre", [](const Known& k) { return array_of(k.centre); });
}

}  // namespace

PYBIND11_MODULE(_native, module) {
  py::register_exception<Failure>(module, "Error", PyExc_ValueError);
  module.def("version", aspect_version);
  define_pose(module);
  define_hypothesis(module);
  define_object(module);
  define_contour(module);
  define_recognition(module);
  define_known_object(module);
  py::class_<Recogniser>(module, "Recogniser")
      .def(py::init<const std::vector<std::pair<std::string, std::optional<py::bytes>>>&,
                    const std::optional<std::string>&, const std::string&, std::string>())
      .def("recognise",
           [](Recogniser& r, const py::array& pixels, const std::string& format, int missed) {
             return std::const_pointer_cast<KeptRecognition>(r.recognise(pixels, format, missed));
           })
      .def_property_readonly("warnings", &Recogniser::warnings)
      // Their names are the recogniser's.
      .def_property_readonly("objects", &Recogniser::objects, py::keep_alive<0, 1>());
}

}  // namespace aspect
