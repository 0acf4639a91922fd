// OpenImageIO costs three seconds to compile: it is included here and nowhere else.
#include "maps/image_file.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <cstring>
#include <optional>
#include <thread>

#include "maps/image_head.h"

namespace sward {
namespace {

void useAllCores() {
    static const bool once = [] {
        const int cores = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
        OIIO::attribute("threads", cores);
        OIIO::attribute("exr_threads", cores);
        return true;
    }();
    (void)once;
}

// Values as they stand in the file: alpha is never multiplied in or out.
OIIO::ImageSpec asStored() {
    OIIO::ImageSpec hints;
    hints.attribute("oiio:UnassociatedAlpha", 1);
    return hints;
}

std::optional<PixelType> typeOf(const OIIO::TypeDesc& type) {
    switch (type.basetype) {
        case OIIO::TypeDesc::UINT8:
            return PixelType::U8;
        case OIIO::TypeDesc::UINT16:
            return PixelType::U16;
        case OIIO::TypeDesc::INT8:
        case OIIO::TypeDesc::INT16:
        case OIIO::TypeDesc::INT32:
        case OIIO::TypeDesc::UINT32:
        case OIIO::TypeDesc::HALF:
        case OIIO::TypeDesc::FLOAT:
        case OIIO::TypeDesc::DOUBLE:
            return PixelType::F32;
        default:
            return {};
    }
}

OIIO::TypeDesc descOf(PixelType type) {
    return type == PixelType::U8    ? OIIO::TypeDesc::UINT8
           : type == PixelType::U16 ? OIIO::TypeDesc::UINT16
                                    : OIIO::TypeDesc::FLOAT;
}

// The type in which a file is read: integers that become floats as they are, before the library makes shares of them.
OIIO::TypeDesc readAs(const OIIO::TypeDesc& stored, PixelType type) {
    const bool numbers = !stored.is_floating_point() && type == PixelType::F32;
    return numbers ? OIIO::TypeDesc(static_cast<OIIO::TypeDesc::BASETYPE>(stored.basetype)) : descOf(type);
}

template <class T>
void toFloats(const std::vector<std::byte>& in, float* out) {
    for (size_t i = 0; i < in.size() / sizeof(T); ++i) {
        T value;
        std::memcpy(&value, in.data() + i * sizeof(T), sizeof(T));
        out[i] = static_cast<float>(value);
    }
}
void numbersToFloats(const OIIO::TypeDesc& type, const std::vector<std::byte>& in, float* out) {
    switch (type.basetype) {
        case OIIO::TypeDesc::INT8:
            return toFloats<int8_t>(in, out);
        case OIIO::TypeDesc::INT16:
            return toFloats<int16_t>(in, out);
        case OIIO::TypeDesc::INT32:
            return toFloats<int32_t>(in, out);
        default:
            return toFloats<uint32_t>(in, out);
    }
}

std::string firstLine(const std::string& text) { return text.substr(0, text.find('\n')); }

class OiioReader final : public ImageReader {
  public:
    OiioReader(std::filesystem::path file, std::unique_ptr<OIIO::ImageInput> input, MapInfo info,
               std::optional<double> noData)
        : file_(std::move(file)),
          input_(std::move(input)),
          info_(info),
          noData_(noData),
          first_(input_->spec().y),
          type_(readAs(input_->spec().format, info.type)) {}
    const MapInfo& info() const override { return info_; }
    std::optional<double> noData() const override { return noData_; }

    Status readRows(int y0, int rows, void* out) override {
        try {
            if (type_ == descOf(info_.type)) return read(y0, rows, out);
            std::vector<std::byte> numbers(rowBytes() * size_t(rows));
            if (Status s = read(y0, rows, numbers.data()); !s) return s;
            numbersToFloats(type_, numbers, static_cast<float*>(out));
            return {};
        } catch (const std::exception& e) {
            return truncated(e.what());
        }
    }

  private:
    bool tiled() const { return input_->spec().tile_width > 0; }
    size_t rowBytes() const { return size_t(info_.width) * size_t(info_.channels) * type_.size(); }
    Status read(int y0, int rows, void* out) {
        return tiled() ? readFromTiles(y0, rows, out) : readFromScanlines(y0, rows, out);
    }
    Error truncated(const std::string& why) const {
        return unsound(fmt::format("is truncated or damaged: {}", firstLine(why)), "export it again").at(file_);
    }
    Status readFromScanlines(int y0, int rows, void* out) {
        // Asked for the file's own type by name, the library would convert through 64 MB of its own.
        const OIIO::ImageSpec& spec = input_->spec();
        const bool asStored = spec.format == type_ && spec.channelformats.empty() && spec.nchannels == info_.channels;
        const OIIO::TypeDesc type = asStored ? OIIO::TypeDesc(OIIO::TypeDesc::UNKNOWN) : type_;
        if (input_->read_scanlines(0, 0, first_ + y0, first_ + y0 + rows, 0, 0, info_.channels, type, out)) return {};
        return truncated(input_->geterror());
    }
    // Tiles may be of any height, so the whole image is read at the first call.
    Status readFromTiles(int y0, int rows, void* out) {
        if (whole_.empty()) {
            whole_.resize(rowBytes() * size_t(info_.height));
            if (!input_->read_image(0, 0, 0, info_.channels, type_, whole_.data()))
                return truncated(input_->geterror());
        }
        std::memcpy(out, whole_.data() + rowBytes() * size_t(y0), rowBytes() * size_t(rows));
        return {};
    }

    std::filesystem::path file_;
    std::unique_ptr<OIIO::ImageInput> input_;
    MapInfo info_;
    std::optional<double> noData_;
    int first_;
    OIIO::TypeDesc type_;  // in which the library gives texels
    std::vector<std::byte> whole_;
};

// Why the library did not open a file whose header is sound.
Error openFault(const std::string& why) {
    if (why.find("ubsampled") != std::string::npos)
        return unsound("has channels of different sizes (subsampled)", "export every channel at the full size");
    if (why.find("upport") != std::string::npos)
        return unsound("is of a kind that is not read", "export floats, or integers of 8, 16 or 32 bits");
    return unsound(fmt::format("is truncated or damaged: {}", firstLine(why)), "export it again");
}

Result<std::unique_ptr<ImageReader>> openFormat(const std::filesystem::path& file, const ImageHead& head) {
    const std::string& format = head.format;
    auto input = OIIO::ImageInput::create(format == "exr" ? "openexr" : format == "tif" ? "tiff" : format);
    if (!input) return unsound(fmt::format("cannot be read: this OpenImageIO has no {}", format)).at(file);
    OIIO::ImageSpec spec;
    if (!input->open(file.string(), spec, asStored())) return openFault(input->geterror()).at(file);
    const std::optional<PixelType> type = typeOf(spec.format);
    if (!type || spec.deep || spec.depth > 1)
        return unsound(fmt::format("holds {}{}", spec.format.c_str(),
                                   spec.deep        ? ", deep"
                                   : spec.depth > 1 ? ", a volume"
                                                    : ""),
                       "export one flat image of floats, or of integers of 8, 16 or 32 bits")
            .at(file);
    if (Status s = checkLimits(file, spec.width, spec.height, spec.nchannels, pixelBytes(*type)); !s) return s.error();
    const MapInfo info{spec.width, spec.height, spec.nchannels, *type};
    return std::unique_ptr<ImageReader>(std::make_unique<OiioReader>(file, std::move(input), info, head.noData));
}

OIIO::ImageSpec specFor(const std::string& format, const MapInfo& info) {
    OIIO::ImageSpec spec(info.width, info.height, info.channels, descOf(info.type));
    if (info.channels == 2) spec.channelnames = {"R", "G"};
    if (info.channels == 2) spec.alpha_channel = -1;
    spec.attribute("oiio:UnassociatedAlpha", 1);
    spec.attribute("DateTime", "");  // else the clock is written, and equal pictures are not equal files
    // The levels that cost half the time of the defaults for a few hundredths of size: saving is waited for.
    spec.attribute("compression", format == "exr" ? "zip:1" : "zip");
    spec.attribute("png:compressionLevel", 2);
    spec.attribute("tiff:zipquality", 1);
    return spec;
}

}  // namespace

Status checkLimits(const std::filesystem::path& file, int64_t width, int64_t height, int64_t channels,
                   size_t bytesPerChannel) {
    if (width < 1 || height < 1)
        return unsound(fmt::format("has size {} x {}", width, height), "a map has at least one texel").at(file);
    if (width > kMaxMapSide || height > kMaxMapSide)
        return unsound(fmt::format("is {} x {}; the limit is {} a side", width, height, kMaxMapSide), "scale it down")
            .at(file);
    if (channels < 1 || channels > 4) return unsound(fmt::format("has {} channels; the limit is 4", channels)).at(file);
    const size_t bytes = size_t(width) * size_t(height) * size_t(channels) * bytesPerChannel;
    if (bytes > kMaxMapBytes)
        return unsound(fmt::format("takes {} MiB; the limit is {}", bytes >> 20, kMaxMapBytes >> 20),
                       "scale it down, or use fewer bits")
            .at(file);
    return {};
}

Result<std::unique_ptr<ImageReader>> ImageReader::open(const std::filesystem::path& file) {
    const Result<ImageHead> head = readImageHead(file);
    if (!head) return head.error();
    if (Status s = checkLimits(file, head->width, head->height, 1, 1); !s) return s.error();
    useAllCores();
    try {
        return openFormat(file, *head);
    } catch (const std::exception& e) {
        return unsound(fmt::format("is truncated or damaged: {}", firstLine(e.what())), "export it again").at(file);
    }
}

Result<std::string> encodeImage(const std::string& format, const MapInfo& info,
                                const std::function<void(int, int, void*)>& rows) {
    const auto refusal = [&](const std::string& why) {
        return failed(fmt::format("cannot be encoded: {}", firstLine(why)));
    };
    useAllCores();
    try {
        auto output = OIIO::ImageOutput::create(format == "exr" ? "openexr" : format == "tif" ? "tiff" : format);
        if (!output) return refusal(OIIO::geterror());
        OIIO::Filesystem::IOVecOutput memory;
        output->set_ioproxy(&memory);
        if (!output->open("memory." + format, specFor(format, info))) return refusal(output->geterror());
        std::vector<std::byte> band(size_t(info.width) * size_t(info.channels) * pixelBytes(info.type) * kTileSize);
        for (int y = 0; y < info.height; y += kTileSize) {
            const int n = std::min(kTileSize, info.height - y);
            rows(y, n, band.data());
            if (!output->write_scanlines(y, y + n, 0, descOf(info.type), band.data()))
                return refusal(output->geterror());
        }
        if (!output->close()) return refusal(output->geterror());
        const auto& bytes = memory.buffer();
        return std::string(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    } catch (const std::exception& e) {
        return refusal(e.what());
    }
}

}  // namespace sward
