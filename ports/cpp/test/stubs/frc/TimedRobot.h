#pragma once

namespace frc {

/** The part of WPILib that the guide's robot needs. */
class TimedRobot {
public:
    virtual ~TimedRobot() = default;
    virtual void RobotPeriodic() {}
};

/** Runs three loops. */
template <typename Robot>
int StartRobot() {
    Robot robot;
    for (int loop = 0; loop < 3; loop++) robot.RobotPeriodic();
    return 0;
}

}  // namespace frc
