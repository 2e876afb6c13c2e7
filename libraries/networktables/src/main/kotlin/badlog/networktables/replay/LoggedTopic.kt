package badlog.networktables.replay

/**
 * A topic with values that are sent exactly as logged, byte for byte.
 *
 * @property name its name in the log.
 * @property type its type in a WPILOG: `double`, `int64[]`, `struct:Pose2d`. Types without a value in NetworkTables are sent as bytes of
 *   that type, which dashboards can read.
 * @property unit its unit, or empty.
 * @property times when each value was logged, on the recording's x axis; ascending.
 * @property payload returns the bytes of a value, as in a record of a WPILOG; they have the size that the type requires.
 */
class LoggedTopic(val name: String, val type: String, val unit: String, val times: DoubleArray, val payload: (index: Int) -> ByteArray)
