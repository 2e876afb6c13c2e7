package badlog.samples

import badlog.samples.match.Order
import badlog.samples.match.Task
import badlog.samples.robot.Superstructure

/** The first seconds of every match: the preloaded piece, then one more from the carpet. */
val TWO_PIECE_AUTONOMOUS: List<Order> = listOf(
    Order(0.0, Task.Wait, Superstructure.STOWED),
    Order(2.2, Task.Wait, Superstructure.RAISING),
    Order(3.6, Task.Wait, Superstructure.SCORING),
    Order(4.5, Task.DriveTo(5.2, 3.4), Superstructure.STOWED),
    Order(7.6, Task.Creep, Superstructure.INTAKING),
    Order(9.4, Task.DriveTo(2.0, 3.0), Superstructure.HOLDING),
    Order(12.4, Task.Aim, Superstructure.RAISING),
    Order(14.4, Task.Wait, Superstructure.SCORING),
    Order(15.3, Task.Wait, Superstructure.STOWED),
)

/** Returns a cycle of teleop from second [at] on. It goes across the field for a piece and back to score it, in 17 s. */
fun cycle(at: Double, load: Task.DriveTo = Task.DriveTo(13.4, 5.6)): List<Order> = listOf(
    Order(at, load, Superstructure.STOWED),
    Order(at + 5.6, Task.Creep, Superstructure.INTAKING),
    Order(at + 7.4, Task.DriveTo(2.6, 3.1), Superstructure.HOLDING),
    Order(at + 12.9, Task.Aim, Superstructure.RAISING),
    Order(at + 15.3, Task.Wait, Superstructure.SCORING),
    Order(at + 16.2, Task.Wait, Superstructure.STOWED),
)
