#include "keiko/files/photometric/intensity_csv.h"

#include "keiko/base/error.h"
#include "keiko/base/input_file.h"
#include "keiko/base/text.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <functional>
#include <numeric>
#include <optional>
#include <string_view>

namespace keiko {
namespace {

std::string_view trimmed(std::string_view text) {
    const auto begin = text.find_first_not_of(" \t\r");
    if (begin == std::string_view::npos) return "";
    return text.substr(begin, text.find_last_not_of(" \t\r") - begin + 1);
}

std::vector<std::string_view> fields_of(std::string_view row) {
    std::vector<std::string_view> fields;
    for (;;) {
        const std::size_t comma = row.find(',');
        fields.push_back(trimmed(row.substr(0, comma)));
        if (comma == std::string_view::npos) return fields;
        row.remove_prefix(comma + 1);
    }
}

std::optional<double> number_in(std::string_view field) {
    double value = 0;
    const auto [end, error] = std::from_chars(field.data(), field.data() + field.size(), value);
    if (error != std::errc() || end != field.data() + field.size() || !std::isfinite(value))
        return {};
    return value;
}

/// Reads row by row.
class CsvReader {
public:
    explicit CsvReader(const std::filesystem::path& path) : path_(path) {}

    void take(std::string_view row) {
        ++line_;
        row = trimmed(row.substr(0, row.find('#')));
        if (row.empty()) return;
        const auto fields = fields_of(row);
        if (columns_.values.empty())
            take_header(fields);
        else
            take_values(fields);
    }

    IntensityColumns finish() && {
        if (columns_.values.empty()) fail("has no row 'theta, ...'");
        if (const std::string fault = table_fault(columns_); !fault.empty())
            throw Error(path_.string(), "", fault);
        return std::move(columns_);
    }

private:
    [[noreturn]] void fail(const std::string& reason) const {
        throw Error(path_.string(), std::to_string(line_), reason);
    }
    double number(std::string_view field) const {
        constexpr double largest = 1e15;
        const auto value = number_in(field);
        if (!value) fail(in_quotes(field) + " is not a number");
        if (std::abs(*value) > largest) fail(in_quotes(field) + " is beyond 1e15");
        return *value;
    }
    void take_header(const std::vector<std::string_view>& fields) {
        if (fields.front() != "theta" || fields.size() < 2)
            fail("the first row must be 'theta' and the angles phi");
        columns_.phi.clear();
        for (std::size_t i = 1; i < fields.size(); ++i) columns_.phi.push_back(number(fields[i]));
        columns_.values.resize(columns_.phi.size());
    }
    void take_values(const std::vector<std::string_view>& fields) {
        if (fields.size() != columns_.phi.size() + 1)
            fail("has " + std::to_string(fields.size()) + " fields, the first row " +
                 std::to_string(columns_.phi.size() + 1));
        columns_.theta.push_back(number(fields.front()));
        for (std::size_t i = 1; i < fields.size(); ++i)
            columns_.values[i - 1].push_back(number(fields[i]));
    }

    const std::filesystem::path& path_;
    std::size_t line_ = 0;
    IntensityColumns columns_;
};

bool ascends(const std::vector<double>& angles, double highest) {
    const bool sorted =
        std::adjacent_find(angles.begin(), angles.end(), std::greater_equal<>()) == angles.end();
    return sorted && angles.front() == 0 && angles.back() <= highest;
}

/// Replaces the values of a row by their mean where they differ.
void even_out(IntensityColumns& columns, std::size_t row) {
    double sum = 0;
    bool even = true;
    for (const auto& column : columns.values) {
        sum += column[row];
        even = even && column[row] == columns.values.front()[row];
    }
    if (even) return;
    for (auto& column : columns.values)
        column[row] = sum / static_cast<double>(columns.values.size());
}

/// Symmetry of the planes, given by the last of them.
PlaneSymmetry symmetry_of(const std::vector<double>& phi) {
    if (phi.size() == 1) return PlaneSymmetry::axial;
    return phi.back() == 90    ? PlaneSymmetry::quadrant
           : phi.back() == 180 ? PlaneSymmetry::bilateral
                               : PlaneSymmetry::none;
}

} // namespace

std::string table_fault(const IntensityColumns& columns) {
    if (columns.theta.empty()) return "the table has no row";
    if (!ascends(columns.theta, 180)) return "theta must ascend from 0 to at most 180";
    if (!ascends(columns.phi, 360)) return "phi must ascend from 0 to at most 360";
    if (columns.values.size() != columns.phi.size()) return "needs a column of values for each phi";
    for (const auto& column : columns.values) {
        if (column.size() != columns.theta.size()) return "needs a value for each theta";
        if (std::any_of(column.begin(), column.end(), [](double x) { return x < 0; }))
            return "an intensity must not be negative";
    }
    return "";
}

IntensityTable intensity_table(IntensityColumns columns, TableInterpolation interpolation) {
    even_out(columns, 0);
    if (columns.theta.back() == 180) even_out(columns, columns.theta.size() - 1);
    std::vector<double> values;
    for (const auto& column : columns.values)
        values.insert(values.end(), column.begin(), column.end());
    const PlaneSymmetry symmetry = symmetry_of(columns.phi);
    return {std::move(columns.theta), std::move(columns.phi), std::move(values), symmetry,
            interpolation};
}

IntensityColumns read_intensity_csv(const std::filesystem::path& path) {
    const std::string text = read_text_file(path);
    CsvReader reader(path);
    std::string_view rest = text;
    while (!rest.empty()) {
        const std::size_t end = std::min(rest.find('\n'), rest.size());
        reader.take(rest.substr(0, end));
        rest.remove_prefix(std::min(end + 1, rest.size()));
    }
    return std::move(reader).finish();
}

} // namespace keiko
