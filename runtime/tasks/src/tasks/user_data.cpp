// User data tasks.

#include <algorithm>

#include <fmt/format.h>

#include <sbgc/client/memory.hpp>
#include <sbgc/client/parameters.hpp>

#include "tasks/agreement.hpp"

namespace sbgc::tasks {
namespace {

Task<Result<msg::ReadExternalData>> read_user_data() {
  co_return co_await detail::call_verified(msg::ReadExternalDataRequest{}, "reading the user data");
}

}  // namespace

Task<Result<Bytes>> download_user_data() {
  const Result<msg::ReadExternalData> answer = co_await read_user_data();
  if (!answer) co_return answer.error();
  co_return Bytes(answer->data.begin(), answer->data.end());
}

Task<Result<void>> upload_user_data(std::size_t offset, Bytes data) {
  if (data.size() > user_data_size || offset > user_data_size - data.size()) {
    co_return ClientError{ErrorCode::invalid,
                          fmt::format("{} bytes at {} do not fit into the {} bytes of user data",
                                      data.size(), offset, user_data_size)};
  }
  Result<msg::ReadExternalData> present = co_await read_user_data();
  if (!present) co_return present.error();
  std::copy(data.begin(), data.end(), present->data.begin() + static_cast<std::ptrdiff_t>(offset));
  ParameterSet wanted;
  if (const Result<void> put = wanted.set(*present); !put) co_return put;
  const WriteReport report = co_await write_parameters(std::move(wanted));
  co_return report.outcome;
}

}  // namespace sbgc::tasks
