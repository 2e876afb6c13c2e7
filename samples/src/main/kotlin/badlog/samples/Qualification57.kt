package badlog.samples

import badlog.samples.bag.BagLog
import badlog.samples.bag.NumberText
import badlog.samples.bag.gzipNeverClosed
import badlog.samples.match.Schedule
import badlog.samples.robot.Battery
import badlog.samples.robot.Drivetrain
import badlog.samples.robot.Mishap
import badlog.samples.robot.Mishaps
import badlog.samples.robot.Robot

/** The time of the hit from the side: 1:10 into the match. */
const val HIT = 72.4

/**
 * Returns a match with a hit from the side. After it, the left encoder's count stands still, and the gyro restarts and drifts.
 *
 * @return the bag before it is compressed.
 */
fun qualification57(): ByteArray {
    val mishaps = Mishaps(listOf(Mishap.Hit(HIT, "WARN: gyro restarted, \"CALIBRATING\", heading is not valid")))
    val robot = Robot(
        seed = 57,
        battery = Battery(ohms = 0.0125, slowOhms = 0.0038, ampHours = 17.5, charge = 0.98),
        drivetrain = Drivetrain(x = 1.55, y = 3.0, heading = StrictMath.PI),
        pressure = 112.0,
        mishaps = mishaps,
    )
    val orders = TWO_PIECE_AUTONOMOUS + cycle(19.4) + cycle(36.3) + cycle(53.4) + cycle(70.6) + cycle(88.2) +
        cycle(105.0) + cycle(122.1) + cycle(139.0)
    val run = Run(seed = 57, robot, Schedule.match(secondsAfter = 26.0), orders, mishaps)
    val values = matchValues("2024-03-16T15:18:52", "57", "Red", "1", "B9, 2023") + ROBOT_VALUES
    val log = BagLog(NumberText.SENSOR_DECIMALS, values)
    log.createMatchTopics(run)
    log.finishInitialization()
    run.loop { log.log() }
    return log.bytes()
}

fun qualification57Compressed(): ByteArray = gzipNeverClosed(qualification57())
