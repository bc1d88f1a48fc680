// A stand-in for the header of an Arduino core: what the sketches use, and the macros that real cores
// define, because these can replace names of the library.
#pragma once

#include <cstddef>
#include <cstdint>

#define PI 3.1415926535897932384626433832795
#define HALF_PI 1.5707963267948966192313216916398
#define TWO_PI 6.283185307179586476925286766559
#define DEG_TO_RAD 0.017453292519943295769236907684886
#define RAD_TO_DEG 57.295779513082320876798154814105
#define EULER 2.718281828459045235360287471352
#define LOW 0x0
#define HIGH 0x1
#define CHANGE 2
#define FALLING 3
#define RISING 4
#define INPUT 0x0
#define OUTPUT 0x1
#define SERIAL 0x0
#define DISPLAY 0x1
#define LSBFIRST 0
#define MSBFIRST 1
#define DEFAULT 1
#define EXTERNAL 0

#define abs(x) ((x) > 0 ? (x) : -(x))
#define round(x) ((x) >= 0 ? (long)((x) + 0.5) : (long)((x)-0.5))
#define constrain(amt, low, high) ((amt) < (low) ? (low) : ((amt) > (high) ? (high) : (amt)))
#define radians(deg) ((deg)*DEG_TO_RAD)
#define degrees(rad) ((rad)*RAD_TO_DEG)
#define sq(x) ((x) * (x))
#define min(a, b) ((a) < (b) ? (a) : (b))
#define max(a, b) ((a) > (b) ? (a) : (b))
#define lowByte(w) ((uint8_t)((w)&0xff))
#define highByte(w) ((uint8_t)((w) >> 8))
#define bitRead(value, bit) (((value) >> (bit)) & 0x01)
#define bitSet(value, bit) ((value) |= (1UL << (bit)))
#define bitClear(value, bit) ((value) &= ~(1UL << (bit)))
#define bit(b) (1UL << (b))
#define word(...) makeWord(__VA_ARGS__)

using byte = std::uint8_t;
using boolean = bool;

unsigned long millis();
unsigned long micros();

class HardwareSerial {
 public:
  void begin(unsigned long baud);
  int available();
  int read();
  std::size_t write(const std::uint8_t* bytes, std::size_t size);
  void print(const char* text);
  void print(double number, int digits = 2);
  void println(const char* text);
  void println(double number, int digits = 2);
};

extern HardwareSerial Serial;   // to the user
extern HardwareSerial Serial1;  // to the gimbal

void setup();
void loop();
