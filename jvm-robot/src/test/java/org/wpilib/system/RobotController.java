package org.wpilib.system;

/** Stands in for WPILib's class of that name, from season 2027 on. */
public final class RobotController {
    private RobotController() {
    }

    public static double getBatteryVoltage() {
        return 11.9;
    }

    public static boolean isSystemTimeValid() {
        return false;
    }
}
