// What a page holds for its script: blocks of text that are not looked at before they are needed.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

namespace aspect {

// A <script> element of that class that no browser runs, with JSON in it that cannot end it.
// Bytes that are not UTF-8 become the replacement character.
std::string json_block(std::string_view css_class, const nlohmann::json& json);

// `text` must hold no <.
std::string text_block(std::string_view css_class, std::string_view text);

// A number that is as long as so many digits need, and 0 where it is not finite.
double with_digits(double number, int digits);

}  // namespace aspect
