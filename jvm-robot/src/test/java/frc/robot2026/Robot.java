package frc.robot2026;

import edu.wpi.first.networktables.DoublePublisher;
import edu.wpi.first.networktables.DoubleTopic;
import edu.wpi.first.networktables.NetworkTableInstance;
import edu.wpi.first.wpilibj.DataLogManager;
import edu.wpi.first.wpilibj.TimedRobot;

public class Robot extends TimedRobot {
    private final DoublePublisher angle;
    private final DoublePublisher target;
    private double position;

    public Robot() {
        DataLogManager.start();
        angle = publisher("/Arm/Angle", "{\"unit\": \"deg\", \"badlog\": [\"differentiate\", \"join:Arm/Position\"]}");
        target = publisher("/Arm/Target", "{\"unit\": \"deg\", \"badlog\": [\"join:Arm/Position\", \"hide\"]}");
    }

    private static DoublePublisher publisher(String name, String properties) {
        DoubleTopic topic = NetworkTableInstance.getDefault().getDoubleTopic(name);
        DoublePublisher publisher = topic.publish();
        topic.setProperties(properties);
        return publisher;
    }

    @Override
    public void robotPeriodic() {
        position = Math.min(45, position + 1.5);
        angle.set(position);
        target.set(45);
    }
}
