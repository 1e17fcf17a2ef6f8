#include "experiments/render/image.h"

#include <gmock/gmock.h>

#include "slam/base/error.h"
#include "tests/experiments/render/colors.h"

namespace ariadne::experiments {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

TEST(Image, IsStoredRowByRowFromTheTop) {
  Image image(3, 2);
  image.At(1, 0) = kRed;
  image.At(2, 1) = kBlack;
  EXPECT_EQ(image.pixels, (std::vector<Rgb>{kWhite, kRed, kWhite, kWhite, kWhite, kBlack}));
}

TEST(Image, RefusesPixelsOutside) {
  Image image(3, 2);
  EXPECT_THAT([&] { image.At(3, 0); }, ThrowsMessage<Error>(HasSubstr("no pixel (3, 0)")));
  EXPECT_THAT([&] { image.At(0, 2); }, ThrowsMessage<Error>(HasSubstr("3 x 2")));
  EXPECT_THROW(image.At(-1, 0), Error);
}

TEST(Image, RefusesImpossibleSizes) {
  EXPECT_THAT([] { Image(0, 5); }, ThrowsMessage<Error>(HasSubstr("0 x 5")));
  EXPECT_THROW(Image(5, -1), Error);
  EXPECT_THROW(Image(40000, 1), Error);
}

TEST(Paste, DropsWhatFallsOutside) {
  Image canvas(2, 2);
  Image part(2, 2, kRed);
  part.At(1, 1) = kBlack;
  Paste(canvas, part, -1, -1);
  EXPECT_EQ(canvas.pixels, (std::vector<Rgb>{kBlack, kWhite, kWhite, kWhite}));
  Paste(canvas, part, 1, 1);
  EXPECT_EQ(canvas.At(1, 1), kRed);
  Paste(canvas, part, 5, 0);
  EXPECT_EQ(canvas.At(1, 0), kWhite);
}

TEST(Cropped, TakesThePartAndRefusesOnesThatStickOut) {
  Image image(4, 3);
  image.At(2, 1) = kRed;
  EXPECT_EQ(Cropped(image, 2, 1, 2, 2).At(0, 0), kRed);
  EXPECT_THROW(Cropped(image, 2, 1, 3, 2), Error);
  EXPECT_THROW(Cropped(image, -1, 0, 2, 2), Error);
}

TEST(Reduced, IsTheMeanOfBlocks) {
  Image image(4, 2, kBlack);
  image.At(0, 0) = {100, 40, 0};
  image.At(3, 1) = kWhite;
  const Image reduced = Reduced(image, 2);
  EXPECT_EQ(reduced.pixels, (std::vector<Rgb>{{25, 10, 0}, {64, 64, 64}}));
  EXPECT_EQ(Reduced(image, 1), image);
  EXPECT_THAT([&] { Reduced(image, 3); }, ThrowsMessage<Error>(HasSubstr("cannot be reduced by 3")));
}

}  // namespace
}  // namespace ariadne::experiments
