package edu.wpi.first.wpilibj;

/** Stands in for WPILib's class of that name, with the parts that the guide's robots need. */
public class TimedRobot {
    /** Called every 20 ms by WPILib. */
    public void robotPeriodic() {
    }
}
