// User data tasks.

#include <algorithm>

#include <fmt/format.h>

#include <sbgc/client/memory.hpp>
#include <sbgc/client/parameters.hpp>

namespace sbgc::tasks {

Task<Result<Bytes>> download_user_data() {
  const Result<msg::ReadExternalData> answer = co_await call(msg::ReadExternalDataRequest{});
  if (!answer) co_return answer.error();
  co_return Bytes(answer->data.begin(), answer->data.end());
}

Task<Result<void>> upload_user_data(std::size_t offset, Bytes data) {
  if (data.size() > user_data_size || offset > user_data_size - data.size()) {
    co_return ClientError{ErrorCode::invalid,
                          fmt::format("{} bytes at {} do not fit into the {} bytes of user data",
                                      data.size(), offset, user_data_size)};
  }
  Result<msg::ReadExternalData> present = co_await call(msg::ReadExternalDataRequest{});
  if (!present) co_return present.error();
  std::ranges::copy(data, present->data.begin() + static_cast<std::ptrdiff_t>(offset));
  ParameterSet wanted;
  if (const Result<void> put = wanted.set(*present); !put) co_return put;
  const WriteReport report = co_await write_parameters(std::move(wanted));
  co_return report.outcome;
}

}  // namespace sbgc::tasks
