#pragma once

namespace frc {

/** Seconds, as WPILib's units have them. */
class Seconds {
public:
    explicit Seconds(double value) : m_value{value} {}
    double value() const { return m_value; }

private:
    double m_value;
};

class Timer {
public:
    static Seconds GetFPGATimestamp() { return Seconds{1.5}; }
};

}  // namespace frc
