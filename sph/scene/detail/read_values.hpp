// Values of a scene's keys that may be left out.
#pragma once

#include <meniscus/data/json/json_reader.hpp>

#include <string>

namespace meniscus {

// Each sets the value where the key is there, and throws as the reader does.
inline void take(const JsonReader& reader, const char* key, double min, double max, double& value) {
    if (reader.has(key))
        value = reader.number(key, min, max);
}

inline void take(const JsonReader& reader, const char* key, int min, int max, int& value) {
    if (reader.has(key))
        value = reader.whole_number(key, min, max);
}

inline void take(const JsonReader& reader, const char* key, bool& value) {
    if (reader.has(key))
        value = reader.truth(key);
}

/// Refuses a key that stands there although something else leaves it without a meaning.
inline void refuse_with(const JsonReader& reader, const char* key, const std::string& because) {
    if (reader.has(key))
        reader.refuse(key, "left out: " + because);
}

} // namespace meniscus
