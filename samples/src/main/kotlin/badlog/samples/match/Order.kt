package badlog.samples.match

import badlog.samples.robot.Superstructure

/** What the drivers, or the autonomous program, want from second [at] on, until the next order. */
class Order(val at: Double, val task: Task, val state: Superstructure, val note: String = "")

/** What is to be done with the drivetrain. */
sealed interface Task {
    data object Wait : Task

    /** To a place on the field, turning toward it first. */
    class DriveTo(val x: Double, val y: Double) : Task

    /** Slowly ahead, onto a game piece. */
    data object Creep : Task

    /** Turning and closing in on the target. */
    data object Aim : Task

    /** At full throttle, against a robot that does not give way. */
    data object Push : Task

    /** Against something that does not move. */
    class PushWall(val throttle: Double) : Task

    data object BackOff : Task
}
