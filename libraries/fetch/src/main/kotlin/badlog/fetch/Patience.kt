package badlog.fetch

import java.time.Duration

/**
 * The times that a fetch waits.
 *
 * @property connect the maximum wait for a robot to answer.
 * @property answer the maximum wait for a robot to accept a login.
 * @property silence the maximum wait for an answer after login; a silent robot counts as gone.
 * @property growth the wait between two listings of a folder, which show the growing files. Loggers write four times a second.
 * @property retry the wait before the next attempt after a connection was lost.
 * @property state the maximum wait for the robot to report whether it is enabled.
 */
class Patience(
    val connect: Duration = Duration.ofSeconds(3),
    val answer: Duration = Duration.ofSeconds(10),
    val silence: Duration = Duration.ofSeconds(10),
    val growth: Duration = Duration.ofMillis(1500),
    val retry: Duration = Duration.ofSeconds(1),
    val state: Duration = Duration.ofSeconds(3),
)
