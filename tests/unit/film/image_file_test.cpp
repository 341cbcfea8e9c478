#include "keiko/film/image_file.h"

#include "keiko/base/error.h"
#include "keiko/base/input_file.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <cstring>
#include <limits>

using namespace keiko;
namespace fs = std::filesystem;

namespace {

class ImageFile : public testing::Test {
protected:
    ImageFile() { fs::create_directories(folder_); }
    ~ImageFile() override { fs::remove_all(folder_); }
    fs::path at(const std::string& name) const { return folder_ / name; }

private:
    fs::path folder_ =
        fs::temp_directory_path() / ("keiko-image-file-" + std::to_string(getpid()) + "-" +
                                     testing::UnitTest::GetInstance()->current_test_info()->name());
};

Film sample_film() {
    Film film{Image(17, 9, 3), Image(17, 9, 1), {}};
    for (const Aov aov : every_aov())
        film.aovs[aov] = Image(17, 9, static_cast<int>(channel_names(aov).size()));
    float value = 0.1F;
    for (float& x : film.color.values) x = value *= 1.01F;
    for (float& x : film.alpha.values) x = std::fmod(value += 0.37F, 1.0F);
    for (auto& [aov, image] : film.aovs)
        for (float& x : image.values) x = value -= 0.61F;
    film.aovs[Aov::face].values[5] = 16777215;
    film.aovs[Aov::depth].values[0] = std::numeric_limits<float>::infinity();
    return film;
}

std::string reason_of(const std::function<void()>& action) {
    try {
        action();
    } catch (const Error& error) {
        return error.what();
    }
    return "no error";
}

} // namespace

TEST_F(ImageFile, ExrKeepsEveryBufferOfAFilm) {
    const Film film = sample_film();
    write_film(at("a.exr"), film);
    const Film back = read_film(at("a.exr"));
    EXPECT_EQ(back.color.width, 17);
    EXPECT_EQ(back.color.height, 9);
    EXPECT_EQ(back.color.values, film.color.values);
    EXPECT_EQ(back.alpha.values, film.alpha.values);
    ASSERT_EQ(back.aovs.size(), film.aovs.size());
    for (const auto& [aov, image] : film.aovs)
        EXPECT_EQ(back.aovs.at(aov).values, image.values) << name_of(aov);
}

TEST_F(ImageFile, ExrNamesItsChannels) {
    write_film(at("a.exr"), sample_film());
    const auto names = read_image(at("a.exr")).channel_names;
    for (const char* name : {"R", "G", "B", "A", "normal.X", "normal.Z", "luminance.Y", "uv.u",
                             "face.id", "patch.id", "depth.Z", "c_plane_uv.v"})
        EXPECT_NE(std::find(names.begin(), names.end(), name), names.end()) << name;
    EXPECT_EQ(names.size(), 4u + 16u);
    EXPECT_EQ(names[0], "R");
}

TEST_F(ImageFile, ExrWithoutAlphaOrAovs) {
    Film film = sample_film();
    film.alpha = {};
    film.aovs.clear();
    write_film(at("a.exr"), film);
    EXPECT_EQ(read_image(at("a.exr")).channel_names, (std::vector<std::string>{"R", "G", "B"}));
    EXPECT_EQ(read_film(at("a.exr")).alpha.channels, 0);
}

TEST_F(ImageFile, PngHoldsTheToneMappedPictureToTheBit) {
    const Film film = sample_film();
    const ToneMapping mapping{.ev = 0};
    write_film(at("a.png"), film, mapping, true);
    const Image display = tone_mapped(film, mapping, true), back = read_image(at("a.png")).image;
    ASSERT_EQ(back.channels, 4);
    ASSERT_EQ(back.values.size(), display.values.size());
    for (std::size_t i = 0; i < back.values.size(); ++i)
        EXPECT_EQ(std::lround(255 * back.values[i]), std::lround(255 * display.values[i])) << i;
}

TEST_F(ImageFile, PngOfGreyAndOfColour) {
    write_png(at("grey.png"), Image(4, 3, 1, 0.2F));
    EXPECT_EQ(read_image(at("grey.png")).image.channels, 1);
    EXPECT_NEAR(read_image(at("grey.png")).image.values[7], 51 / 255.0, 1e-7);
    write_film(at("colour.PNG"), sample_film());
    EXPECT_EQ(read_image(at("colour.PNG")).image.channels, 3);
}

TEST_F(ImageFile, BytesDependOnTheFilmAlone) {
    const Film film = sample_film();
    EXPECT_EQ(encode_exr(film), encode_exr(film));
    const Image display = tone_mapped(film);
    EXPECT_EQ(encode_png(display), encode_png(display));
    write_film(at("a.exr"), film);
    write_film(at("other name.exr"), film);
    EXPECT_EQ(read_file(at("a.exr")), read_file(at("other name.exr")));
    EXPECT_EQ(read_file(at("a.exr")), encode_exr(film));
    EXPECT_NE(encode_exr(film).find("1970:01:01"), std::string::npos) << "no time of day";
    char host[256] = {};
    ASSERT_EQ(gethostname(host, sizeof host - 1), 0);
    for (const std::string& bytes : {encode_exr(film), encode_png(display)}) {
        EXPECT_EQ(bytes.find("tIME"), std::string::npos);
        EXPECT_EQ(bytes.find(std::string(host) + '\0'), std::string::npos);
    }
}

TEST_F(ImageFile, EncodedPngIsAPng) {
    const std::string bytes = encode_png(Image(2, 2, 3, 0.5F));
    EXPECT_EQ(bytes.substr(0, 8), "\x89PNG\r\n\x1a\n");
    EXPECT_NE(bytes.find("IEND"), std::string::npos);
}

TEST_F(ImageFile, UnknownExtensionNamesTheKnownOnes) {
    const std::string reason = reason_of([&] { write_film(at("a.jpg"), sample_film()); });
    EXPECT_NE(reason.find("a.jpg"), std::string::npos);
    EXPECT_NE(reason.find(".exr"), std::string::npos);
    EXPECT_NE(reason.find(".png"), std::string::npos);
    EXPECT_THROW(require_image_extension("picture"), Error);
    EXPECT_NO_THROW(require_image_extension("picture.EXR"));
}

/// File with another last column and row in its header.
std::string with_data_window(std::string bytes, std::int32_t last_column, std::int32_t last_row) {
    const std::string key("dataWindow\0box2i\0", 17);
    const std::size_t at = bytes.find(key) + key.size() + 3 * sizeof(std::int32_t);
    std::memcpy(&bytes[at], &last_column, sizeof last_column);
    std::memcpy(&bytes[at + sizeof last_column], &last_row, sizeof last_row);
    return bytes;
}

TEST_F(ImageFile, SizesThatNoPictureHasAreRefused) {
    const std::string bytes = encode_exr(Film{Image(4, 3, 3), {}, {}});
    EXPECT_EQ(decode_exr(with_data_window(bytes, 3, 2), "a.exr").image.width, 4);
    for (const auto& [column, row] :
         {std::pair{69999, 2}, {3, 69999}, {(1 << 30) - 2, (1 << 30) - 2}})
        EXPECT_NE(reason_of([&, c = column, r = row] {
                      decode_exr(with_data_window(bytes, c, r), "a.exr");
                  }).find("a.exr: "),
                  std::string::npos);
    EXPECT_NE(reason_of([&] {
                  decode_exr(with_data_window(bytes, 69999, 2), "a.exr");
              }).find("too large"),
              std::string::npos);
}

TEST_F(ImageFile, ErrorsNameTheFile) {
    EXPECT_NE(reason_of([&] { read_image(at("absent.png")); }).find("absent.png"),
              std::string::npos);
    EXPECT_NE(reason_of([&] { write_png(at("none/a.png"), Image(1, 1, 3)); }).find("none/a.png"),
              std::string::npos);
    EXPECT_NE(reason_of([&] { write_png(at("empty.png"), Image()); }).find("empty.png"),
              std::string::npos);
    EXPECT_FALSE(fs::exists(at("empty.png")));
    write_png(at("grey.png"), Image(4, 3, 1));
    EXPECT_NE(reason_of([&] { read_film(at("grey.png")); }).find("grey.png"), std::string::npos);
    Film film = sample_film();
    film.aovs[Aov::uv] = Image(3, 3, 2);
    EXPECT_NE(reason_of([&] { write_film(at("a.exr"), film); }).find("a.exr:uv.u"),
              std::string::npos);
}
