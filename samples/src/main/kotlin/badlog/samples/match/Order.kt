package badlog.samples.match

import badlog.samples.robot.Superstructure

/** An order by the drivers or the autonomous program, valid from second [at] until the next one. */
class Order(val at: Double, val task: Task, val state: Superstructure, val note: String = "")

/** A task for the drivetrain. */
sealed interface Task {
    data object Wait : Task

    /** Drive to a place on the field, after turning toward it. */
    class DriveTo(val x: Double, val y: Double) : Task

    /** Drive slowly ahead, onto a game piece. */
    data object Creep : Task

    /** Turn to the target and approach it. */
    data object Aim : Task

    /** Push at full throttle against a robot that does not yield. */
    data object Push : Task

    /** Push against something that does not move. */
    class PushWall(val throttle: Double) : Task

    data object BackOff : Task
}
