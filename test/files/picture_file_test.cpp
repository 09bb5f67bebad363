#include "talus/files/picture_file.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <string>

#include "support/input_folder.hpp"
#include "support/pictures.hpp"
#include "talus/core/bytes.hpp"
#include "talus/files/base64.hpp"

namespace talus {
namespace {

using testing_tools::jpeg_head;
using testing_tools::small_png;

class PictureFile : public testing_tools::InputFolder {
 protected:
  static std::string refusal(const std::string& bytes) {
    return said_by([&] { (void)picture_in(bytes); });
  }
  template <class Work>
  static std::string said_by(Work&& work) {
    try {
      work();
    } catch (const BadBytes& bad) {
      return bad.what();
    }
    return "was read";
  }
  [[nodiscard]] std::string refusal_of_file(const std::string& name) const {
    return said_by([&] { (void)data_address_of_picture(path(name)); });
  }
};

TEST_F(PictureFile, HasTheSizeOfItsHeader) {
  const Picture png = picture_in(small_png(240, 80));
  EXPECT_EQ(png.media_type, "image/png");
  EXPECT_EQ(png.width, 240U);
  EXPECT_EQ(png.height, 80U);
  const Picture jpeg = picture_in(jpeg_head(320, 200));
  EXPECT_EQ(jpeg.media_type, "image/jpeg");
  EXPECT_EQ(jpeg.width, 320U);
  EXPECT_EQ(jpeg.height, 200U);
}

TEST_F(PictureFile, IsPngOrJpeg) {
  const std::string neither = "it is neither a PNG nor a JPEG picture";
  EXPECT_EQ(refusal(""), neither);
  EXPECT_EQ(refusal("<svg xmlns=\"http://www.w3.org/2000/svg\"><script>1</script></svg>"), neither);
  EXPECT_EQ(refusal("GIF89a"), neither);
  EXPECT_EQ(refusal(small_png(4, 4).substr(0, 20)), "the PNG picture is damaged");
  EXPECT_EQ(refusal(jpeg_head(4, 4).substr(0, 26)), "the JPEG picture is damaged");
  EXPECT_EQ(refusal(std::string("\xff\xd8\xff\xe0\0\0\xff\xd9", 8)), "the JPEG picture is damaged");
}

TEST_F(PictureFile, HasALimitedNumberOfPixels) {
  EXPECT_EQ(refusal(small_png(4000, 4000)), "was read");
  EXPECT_EQ(refusal(small_png(4001, 10)), "it has 4001 x 10 pixels; expected at most 4000 a side");
  EXPECT_EQ(refusal(jpeg_head(10, 65000)), "it has 10 x 65000 pixels; expected at most 4000 a side");
  EXPECT_EQ(refusal(small_png(0, 10)), "the picture has no pixels");
}

TEST_F(PictureFile, BecomesADataAddress) {
  const std::string bytes = small_png(3, 2);
  write("logo.png", bytes);
  const std::vector<std::uint8_t> numbers(bytes.begin(), bytes.end());
  EXPECT_EQ(data_address_of_picture(path("logo.png")), "data:image/png;base64," + base64(numbers));
}

TEST_F(PictureFile, IsAnOrdinaryFileOfLimitedSize) {
  write("large.png", small_png(3, 2) + std::string(most_picture_bytes, '\0'));
  EXPECT_EQ(refusal_of_file("large.png"), "it is larger than 512 kB");
  EXPECT_EQ(refusal_of_file("not-there.png"), "No such file or directory");
  EXPECT_EQ(refusal_of_file(""), "it is a folder");
  EXPECT_EQ(said_by([] { (void)data_address_of_picture("/dev/zero"); }), "it is a device");
}

// RFC 4648, section 10.
TEST(Base64, IsThatOfTheStandard) {
  const auto of = [](const std::string& text) { return base64(std::vector<std::uint8_t>(text.begin(), text.end())); };
  EXPECT_EQ(of(""), "");
  EXPECT_EQ(of("f"), "Zg==");
  EXPECT_EQ(of("fo"), "Zm8=");
  EXPECT_EQ(of("foo"), "Zm9v");
  EXPECT_EQ(of("foobar"), "Zm9vYmFy");
}

}  // namespace
}  // namespace talus
