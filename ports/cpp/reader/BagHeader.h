#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "badlog/Recording.h"

namespace badlog::reader {

/** A topic as the line of JSON describes it. */
struct BagTopic {
    std::string name;
    std::string unit = "ul";
    std::vector<std::string> attributes;
};

/** The content of the line of JSON, in its order. */
struct BagHeader {
    std::vector<BagTopic> topics;
    std::vector<RecordedValue> values;

    std::vector<std::string> Names() const;
};

/** Returns the header, or nothing if the line is not one whole JSON object. */
std::optional<BagHeader> ReadHeader(std::string_view line);

}  // namespace badlog::reader
