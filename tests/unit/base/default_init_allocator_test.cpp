#include "keiko/base/memory.h"

#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <vector>

using namespace keiko;

namespace {

struct Record {
    double number = 7;
    std::optional<std::string> text;
};

} // namespace

TEST(DefaultInitAllocator, MakesRecordsAsTheirInitialisersSay) {
    std::vector<Record, DefaultInitAllocator<Record>> records(100);
    for (Record& record : records) record = {1, "written"};
    records.clear();
    records.resize(50); // in the same memory
    records.emplace_back();
    for (const Record& record : records) {
        EXPECT_EQ(record.number, 7);
        EXPECT_FALSE(record.text);
    }
    records.push_back({3, "given"});
    records.reserve(200);
    EXPECT_EQ(records.back().number, 3);
    EXPECT_EQ(records.back().text, "given");
}
