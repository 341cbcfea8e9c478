#pragma once

#include "keiko/math/vec.h"

#include "tests/support/paths.h"
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace keiko::test {

/// One case of an oracle table; columns by name without their unit, e.g. "in.d". A column that is
/// not there throws.
class OracleRow {
public:
    OracleRow(const std::map<std::string, std::size_t>& columns, std::vector<std::string> fields)
        : columns_(&columns), fields_(std::move(fields)) {}

    const std::string& text(const std::string& name) const {
        const auto column = columns_->find(name);
        if (column == columns_->end()) throw std::out_of_range("no oracle column " + name);
        return fields_.at(column->second);
    }
    const std::string& id() const { return text("id"); }
    /// Whether the field has a value.
    bool has(const std::string& name) const { return !text(name).empty(); }
    double number(const std::string& name) const { return std::stod(text(name)); }
    int integer(const std::string& name) const { return std::stoi(text(name)); }
    Vec3 vector(const std::string& name) const {
        return {number(name + "_x"), number(name + "_y"), number(name + "_z")};
    }
    /// Unit vectors were rounded when they were written.
    Vec3 unit(const std::string& name) const { return vector(name).normalized(); }
    std::vector<double> list(const std::string& name) const {
        std::vector<double> values;
        std::istringstream in(text(name));
        for (std::string value; std::getline(in, value, ';');) values.push_back(std::stod(value));
        return values;
    }
    std::vector<Vec3> points(const std::string& name) const {
        const std::vector<double> values = list(name);
        std::vector<Vec3> result;
        for (std::size_t i = 0; i + 2 < values.size(); i += 3)
            result.emplace_back(values[i], values[i + 1], values[i + 2]);
        return result;
    }

private:
    const std::map<std::string, std::size_t>* columns_;
    std::vector<std::string> fields_;
};

/// A table of tests/data/oracle: independent reference values found by brute force.
class OracleTable {
public:
    explicit OracleTable(const std::string& name) {
        std::ifstream in(repository("tests/data/oracle/" + name + ".csv"));
        std::string line;
        if (!std::getline(in, line)) throw std::runtime_error("no oracle table " + name);
        const std::vector<std::string> header = split(line);
        for (std::size_t i = 0; i < header.size(); ++i)
            columns_[header[i].substr(0, header[i].find('['))] = i;
        while (std::getline(in, line)) rows_.emplace_back(columns_, split(line));
    }
    OracleTable(const OracleTable&) = delete;
    OracleTable& operator=(const OracleTable&) = delete;

    auto begin() const { return rows_.begin(); }
    auto end() const { return rows_.end(); }
    std::size_t size() const { return rows_.size(); }

private:
    static std::vector<std::string> split(const std::string& line) {
        std::vector<std::string> fields(1);
        for (const char c : line) {
            if (c == ',')
                fields.emplace_back();
            else if (c != '\r')
                fields.back() += c;
        }
        return fields;
    }

    std::map<std::string, std::size_t> columns_;
    std::vector<OracleRow> rows_;
};

/// The largest relative error met so far, kept beside the test's name in the XML report.
class WorstError {
public:
    explicit WorstError(std::string column) : column_(std::move(column)) {}
    ~WorstError() {
        EXPECT_GT(count_, 0) << "no row of the oracle was compared for " << column_;
        std::ostringstream worst;
        worst << worst_ << " over " << count_ << " rows";
        testing::Test::RecordProperty(column_, worst.str());
    }
    WorstError(const WorstError&) = delete;
    WorstError& operator=(const WorstError&) = delete;

    /// Expects |actual - expected| <= tolerance |expected|, and 0 to be met within `zero`.
    void compare(const OracleRow& row, double actual, double expected, double tolerance,
                 double zero = 1e-12) {
        const double error = std::abs(actual - expected);
        ++count_;
        if (expected != 0) worst_ = std::max(worst_, error / std::abs(expected));
        EXPECT_LE(error, expected == 0 ? zero : tolerance * std::abs(expected))
            << row.id() << " " << column_ << ": " << actual << " instead of " << expected;
    }

private:
    std::string column_;
    double worst_ = 0;
    int count_ = 0;
};

} // namespace keiko::test
