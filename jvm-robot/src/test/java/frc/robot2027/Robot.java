package frc.robot2027;

import org.wpilib.framework.TimedRobot;
import org.wpilib.system.DataLogManager;
import org.wpilib.telemetry.Telemetry;

public class Robot extends TimedRobot {
    private double position;

    public Robot() {
        DataLogManager.start();
        Telemetry.setProperty("Arm/Angle", "unit", "\"deg\"");
        Telemetry.setProperty("Arm/Angle", "badlog", "[\"differentiate\", \"join:Arm/Position\"]");
        Telemetry.setProperty("Arm/Target", "unit", "\"deg\"");
        Telemetry.setProperty("Arm/Target", "badlog", "[\"join:Arm/Position\", \"hide\"]");
    }

    @Override
    public void robotPeriodic() {
        position = Math.min(45, position + 1.5);
        Telemetry.log("Arm/Angle", position);
        Telemetry.log("Arm/Target", 45.0);
    }
}
