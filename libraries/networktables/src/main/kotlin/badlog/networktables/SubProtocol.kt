package badlog.networktables

/**
 * The WebSocket subprotocols of NetworkTables 4 that a client may request, the best one first.
 *
 * @property id its name in a handshake.
 */
enum class SubProtocol(val id: String) {
    V4_1("v4.1.networktables.first.wpi.edu"),
    V4_0("networktables.first.wpi.edu"),

    /** Only for requests for the time. */
    TIME_ONLY("rtt.networktables.first.wpi.edu"),
}
