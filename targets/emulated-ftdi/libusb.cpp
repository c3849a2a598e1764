// The 28 functions of libusb-1.0 that libftdi 1.5 calls, with the emulated adapter behind them.
#include <libusb.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>
#include <targets/emulated-ftdi/emulator.hpp>

struct libusb_context {
  int unused;
};
struct libusb_device {
  int unused;
};
struct libusb_device_handle {
  std::uint64_t opened;
};

namespace {

using eagerx::emulated::emulator;

libusb_context context{};
libusb_device device{};
// Interface i of a chip has the endpoints 0x81 + 2i (to the host) and 0x02 + 2i.
constexpr unsigned kMostInterfaces = 4;
constexpr libusb_endpoint_descriptor endpoint(std::uint8_t address) {
  return {7, LIBUSB_DT_ENDPOINT, address, LIBUSB_TRANSFER_TYPE_BULK, 512, 0, 0, 0, nullptr, 0};
}
const libusb_endpoint_descriptor endpoints[kMostInterfaces][2] = {{endpoint(0x81), endpoint(0x02)},
                                                                  {endpoint(0x83), endpoint(0x04)},
                                                                  {endpoint(0x85), endpoint(0x06)},
                                                                  {endpoint(0x87), endpoint(0x08)}};
std::array<libusb_interface_descriptor, kMostInterfaces> interface_descriptors{};
std::array<libusb_interface, kMostInterfaces> usb_interfaces{};
libusb_config_descriptor config_descriptor{};

unsigned interface_of(unsigned char address) {
  const unsigned number = address & 0x0fU;
  return (address & LIBUSB_ENDPOINT_IN) != 0 ? (number - 1) / 2 : number / 2 - 1;
}

int bulk(libusb_device_handle* handle, unsigned char endpoint, unsigned char* data, int length,
         int& moved, unsigned timeout) {
  if ((endpoint & LIBUSB_ENDPOINT_IN) != 0) {
    return emulator().bulk_in(handle->opened, interface_of(endpoint), data, length, moved, timeout);
  }
  const int result = emulator().bulk_out(handle->opened, interface_of(endpoint), data, length);
  moved = result < 0 ? 0 : result;
  return result < 0 ? result : 0;
}

void carry_out(libusb_transfer* transfer) {
  int moved = 0;
  const int result = bulk(transfer->dev_handle, transfer->endpoint, transfer->buffer,
                          transfer->length, moved, transfer->timeout);
  transfer->actual_length = moved;
  transfer->status = result == 0                      ? LIBUSB_TRANSFER_COMPLETED
                     : result == LIBUSB_ERROR_TIMEOUT ? LIBUSB_TRANSFER_TIMED_OUT
                                                      : LIBUSB_TRANSFER_NO_DEVICE;
  transfer->callback(transfer);
}

// Submitted and not carried out yet.
std::array<libusb_transfer*, 64> submitted{};
std::size_t submissions = 0;

}  // namespace

extern "C" {

int libusb_init(libusb_context** to) {
  emulator();
  if (to != nullptr) *to = &context;
  return 0;
}
void libusb_exit(libusb_context* /*context*/) {}

ssize_t libusb_get_device_list(libusb_context* /*context*/, libusb_device*** list) {
  *list = static_cast<libusb_device**>(std::calloc(2, sizeof(libusb_device*)));
  if (!emulator().is_there()) return 0;
  (*list)[0] = &device;
  return 1;
}
void libusb_free_device_list(libusb_device** list, int /*unref*/) {
  std::free(list);
}
libusb_device* libusb_ref_device(libusb_device* of) {
  return of;
}
void libusb_unref_device(libusb_device* /*device*/) {}

int libusb_get_device_descriptor(libusb_device* /*device*/, libusb_device_descriptor* to) {
  *to = {};
  to->bLength = LIBUSB_DT_DEVICE_SIZE;
  to->bDescriptorType = LIBUSB_DT_DEVICE;
  to->bcdUSB = 0x0200;
  to->bMaxPacketSize0 = 64;
  to->idVendor = 0x0403;
  to->idProduct = emulator().model().product;
  to->bcdDevice = emulator().model().release;
  to->iManufacturer = 1;
  to->iProduct = 2;
  to->iSerialNumber = 3;
  to->bNumConfigurations = 1;
  return 0;
}
int libusb_get_config_descriptor(libusb_device* /*device*/, std::uint8_t /*index*/,
                                 libusb_config_descriptor** to) {
  for (std::size_t i = 0; i < kMostInterfaces; ++i) {
    interface_descriptors[i].bInterfaceNumber = static_cast<std::uint8_t>(i);
    interface_descriptors[i].bNumEndpoints = 2;
    interface_descriptors[i].endpoint = endpoints[i];
    interface_descriptors[i].bInterfaceClass = LIBUSB_CLASS_VENDOR_SPEC;
    usb_interfaces[i].altsetting = &interface_descriptors[i];
    usb_interfaces[i].num_altsetting = 1;
  }
  config_descriptor.bNumInterfaces = static_cast<std::uint8_t>(emulator().model().interfaces);
  config_descriptor.bConfigurationValue = 1;
  config_descriptor.interface = usb_interfaces.data();
  *to = &config_descriptor;
  return 0;
}
void libusb_free_config_descriptor(libusb_config_descriptor* /*config*/) {}

int libusb_open(libusb_device* /*device*/, libusb_device_handle** to) {
  if (!emulator().is_there()) return LIBUSB_ERROR_NO_DEVICE;
  *to = new libusb_device_handle{emulator().open()};
  return 0;
}
void libusb_close(libusb_device_handle* handle) {
  delete handle;
}

int libusb_get_string_descriptor_ascii(libusb_device_handle* /*handle*/, std::uint8_t index,
                                       unsigned char* to, int length) {
  const std::string product = std::string("Emulated ") + emulator().model().name;
  const char* const text = index == 1 ? "FTDI" : index == 2 ? product.c_str() : "EAGERX01";
  return std::snprintf(reinterpret_cast<char*>(to), static_cast<std::size_t>(length), "%s", text);
}
int libusb_get_configuration(libusb_device_handle* /*handle*/, int* config) {
  *config = 1;
  return 0;
}
int libusb_set_configuration(libusb_device_handle* /*handle*/, int /*config*/) {
  return 0;
}
int libusb_claim_interface(libusb_device_handle* /*handle*/, int number) {
  const bool is_there =
      number >= 0 && static_cast<unsigned>(number) < emulator().model().interfaces;
  return is_there ? 0 : LIBUSB_ERROR_NOT_FOUND;
}
int libusb_release_interface(libusb_device_handle* /*handle*/, int /*number*/) {
  return 0;
}
int libusb_detach_kernel_driver(libusb_device_handle* /*handle*/, int /*number*/) {
  return LIBUSB_ERROR_NOT_FOUND;
}
int libusb_set_auto_detach_kernel_driver(libusb_device_handle* /*handle*/, int /*enable*/) {
  return 0;
}
std::uint8_t libusb_get_bus_number(libusb_device* /*device*/) {
  return 1;
}
std::uint8_t libusb_get_device_address(libusb_device* /*device*/) {
  return 2;
}

int libusb_control_transfer(libusb_device_handle* handle, std::uint8_t type, std::uint8_t request,
                            std::uint16_t value, std::uint16_t index, unsigned char* data,
                            std::uint16_t length, unsigned /*timeout*/) {
  // The low byte of the index is the interface, 1 for A; 0 stands for A too.
  const unsigned interface = (index & 0xffU) == 0 ? 0 : (index & 0xffU) - 1;
  return emulator().control(handle->opened, interface, type, request, value, data, length);
}
int libusb_bulk_transfer(libusb_device_handle* handle, unsigned char endpoint, unsigned char* data,
                         int length, int* moved, unsigned timeout) {
  return bulk(handle, endpoint, data, length, *moved, timeout);
}

libusb_transfer* libusb_alloc_transfer(int packets) {
  return static_cast<libusb_transfer*>(
      std::calloc(1, sizeof(libusb_transfer) +
                         static_cast<std::size_t>(packets) * sizeof(libusb_iso_packet_descriptor)));
}
void libusb_free_transfer(libusb_transfer* transfer) {
  std::free(transfer);
}
int libusb_submit_transfer(libusb_transfer* transfer) {
  if (submissions == submitted.size()) return LIBUSB_ERROR_NO_MEM;
  submitted[submissions++] = transfer;
  return 0;
}
int libusb_cancel_transfer(libusb_transfer* transfer) {
  for (std::size_t i = 0; i < submissions; ++i) {
    if (submitted[i] != transfer) continue;
    for (--submissions; i < submissions; ++i) submitted[i] = submitted[i + 1];
    transfer->status = LIBUSB_TRANSFER_CANCELLED;
    transfer->actual_length = 0;
    transfer->callback(transfer);
    return 0;
  }
  return LIBUSB_ERROR_NOT_FOUND;
}
int libusb_handle_events_timeout(libusb_context* /*context*/, timeval* /*timeout*/) {
  const std::size_t due = submissions;
  const auto all = submitted;
  submissions = 0;  // callbacks may submit again
  for (std::size_t i = 0; i < due; ++i) carry_out(all[i]);
  return 0;
}
int libusb_handle_events_timeout_completed(libusb_context* of, timeval* timeout,
                                           int* /*completed*/) {
  return libusb_handle_events_timeout(of, timeout);
}

}  // extern "C"
