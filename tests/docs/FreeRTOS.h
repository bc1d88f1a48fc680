// The part of FreeRTOS that the guides use, for the compiler only.
#pragma once

#include <cstddef>
#include <cstdint>

extern "C" {
using BaseType_t = long;
using TickType_t = std::uint32_t;
inline constexpr BaseType_t pdTRUE = 1;
inline constexpr BaseType_t pdFALSE = 0;
inline constexpr TickType_t portTICK_PERIOD_MS = 1;
#define portYIELD_FROM_ISR(is_needed) static_cast<void>(is_needed)

using QueueHandle_t = struct QueueDefinition*;
BaseType_t xQueueSend(QueueHandle_t queue, const void* item, TickType_t wait);
BaseType_t xQueueReceive(QueueHandle_t queue, void* item, TickType_t wait);
BaseType_t xQueueOverwrite(QueueHandle_t queue, const void* item);

using StreamBufferHandle_t = struct StreamBufferDef_t*;
std::size_t xStreamBufferSendFromISR(StreamBufferHandle_t buffer, const void* bytes,
                                     std::size_t size, BaseType_t* is_woken);
std::size_t xStreamBufferReceive(StreamBufferHandle_t buffer, void* bytes, std::size_t capacity,
                                 TickType_t wait);

TickType_t xTaskGetTickCount();
}
