package org.wpilib.driverstation;

/** Stands in for WPILib's class of that name, from season 2027 on. */
public final class RobotState {
    private RobotState() {
    }

    public static boolean isEnabled() {
        return false;
    }

    public static boolean isDSAttached() {
        return true;
    }
}
