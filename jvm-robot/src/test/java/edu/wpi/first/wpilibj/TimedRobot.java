package edu.wpi.first.wpilibj;

/** Stands for WPILib's class of that name: what the robots of the guide need of it. */
public class TimedRobot {
    /** Called every 20 ms by WPILib. */
    public void robotPeriodic() {
    }
}
