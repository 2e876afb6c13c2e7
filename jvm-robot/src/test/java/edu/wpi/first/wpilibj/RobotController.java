package edu.wpi.first.wpilibj;

/** Stands in for WPILib's class of that name, up to season 2026. */
public final class RobotController {
    public static boolean systemTimeValid;

    private RobotController() {
    }

    public static double getBatteryVoltage() {
        return 12.6;
    }

    public static boolean isSystemTimeValid() {
        return systemTimeValid;
    }
}
