package frc.robot;

import badlog.lib.BadLog;
import badlog.lib.DataInferMode;
import badlog.lib.Events;
import badlog.lib.Publisher;
import badlog.lib.RobotLog;
import edu.wpi.first.wpilibj.TimedRobot;

public class Robot extends TimedRobot {
    private final RobotLog log = RobotLog.start();
    private final Publisher target;
    private final Events events;
    private double angle;

    public Robot() {
        BadLog.createValue("Arm/P", "0.25");
        BadLog.createTopicDouble("Arm/Angle", "deg", () -> angle, "join:Arm/Position");
        BadLog.createTopicBoolean("Arm/At Target", BadLog.UNITLESS, () -> angle > 44);
        target = BadLog.createPublisher("Arm/Target", "deg", DataInferMode.LAST, "join:Arm/Position");
        events = BadLog.createEvents("Arm/Events");
    }

    @Override
    public void robotPeriodic() {
        if (angle == 0) {
            events.event("arm leaves home");
        }
        target.publish(45);
        angle = Math.min(45, angle + 1.5);
        log.periodic();
    }
}
