package edu.wpi.first.wpilibj;

/** Stands in for WPILib's class of that name, with what the robots of the guide need. */
public class TimedRobot {
    /** Called every 20 ms by WPILib. */
    public void robotPeriodic() {
    }
}
