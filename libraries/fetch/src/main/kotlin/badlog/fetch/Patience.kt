package badlog.fetch

import java.time.Duration

/**
 * How long a fetch waits for what.
 *
 * @property connect for a robot to answer.
 * @property answer for a robot to let somebody in.
 * @property silence for an answer once it did; a silent robot counts as gone.
 * @property growth between two looks at a folder, which show which of its files grow. Loggers write four times a second.
 * @property retry before the next try after a connection was lost.
 * @property state for the robot to tell whether it is enabled.
 */
public class Patience(
    public val connect: Duration = Duration.ofSeconds(3),
    public val answer: Duration = Duration.ofSeconds(10),
    public val silence: Duration = Duration.ofSeconds(10),
    public val growth: Duration = Duration.ofMillis(1500),
    public val retry: Duration = Duration.ofSeconds(1),
    public val state: Duration = Duration.ofSeconds(3),
)
