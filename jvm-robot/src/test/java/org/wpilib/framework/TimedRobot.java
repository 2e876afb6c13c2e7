package org.wpilib.framework;

/** Stands in for WPILib's class of this name for the guides' robots. */
public class TimedRobot {
    public void robotPeriodic() {}
}
