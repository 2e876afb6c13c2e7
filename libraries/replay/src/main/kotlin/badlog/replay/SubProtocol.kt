package badlog.replay

/** The subprotocols of NT4 that a client may ask for, the best one first. */
internal enum class SubProtocol(val id: String) {
    V4_1("v4.1.networktables.first.wpi.edu"),
    V4_0("networktables.first.wpi.edu"),

    /** For nothing but questions for the time. */
    TIME_ONLY("rtt.networktables.first.wpi.edu"),
}
