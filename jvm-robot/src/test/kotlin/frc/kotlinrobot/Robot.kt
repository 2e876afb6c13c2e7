package frc.kotlinrobot

import badlog.lib.BadLog
import badlog.lib.DataInferMode
import badlog.lib.Events
import badlog.lib.Publisher
import badlog.lib.RobotLog
import badlog.lib.RobotLogOptions
import edu.wpi.first.wpilibj.TimedRobot

class Robot : TimedRobot() {
    private val log = RobotLog.start(RobotLogOptions().apply { isCompressed = true })
    private var angle = 0.0
    private val target: Publisher
    private val events: Events

    init {
        BadLog.createValue("Arm/P", "0.25")
        BadLog.createTopicDouble("Arm/Angle", "deg", { angle }, "join:Arm/Position")
        BadLog.createTopicBoolean("Arm/At Target", BadLog.UNITLESS, { angle > 44 })
        target = BadLog.createPublisher("Arm/Target", "deg", DataInferMode.LAST, "join:Arm/Position")
        events = BadLog.createEvents("Arm/Events")
    }

    override fun robotPeriodic() {
        if (angle == 0.0) events.event("arm leaves home")
        target.publish(45.0)
        angle = minOf(45.0, angle + 1.5)
        log.periodic()
    }
}
