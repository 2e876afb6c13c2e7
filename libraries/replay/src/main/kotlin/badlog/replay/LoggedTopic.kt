package badlog.replay

/**
 * A topic whose values are sent as they stand in their log, to the byte.
 *
 * @property name what the log calls it.
 * @property type its type, as a WPILOG has it: `double`, `int64[]`, `struct:Pose2d`. What NetworkTables has no value for is sent as
 *   bytes of that type, which dashboards know how to read.
 * @property unit its unit, or empty.
 * @property times when each value was logged, on the recording's x axis; ascending.
 * @property payload gives the bytes of a value, as a record of a WPILOG has them; they are as many as the type asks for.
 */
public class LoggedTopic(
    public val name: String,
    public val type: String,
    public val unit: String,
    public val times: DoubleArray,
    public val payload: (index: Int) -> ByteArray,
)
