package badlog.signals.vocabulary

/** The signals that are needed for every log, whatever the question. */
internal val OF_EVERY_LOG: Set<String>
    get() = setOf(EVENT_NAME, MATCH_TYPE, MATCH_NUMBER, ROBOT_ENABLED, ROBOT_AUTONOMOUS, ROBOT_TEST, OP_MODE, BATTERY_NAME)

/** The signal of the event's name. */
internal const val EVENT_NAME: String = "event name"

/** The signal of the match's type. */
internal const val MATCH_TYPE: String = "match type"

/** The signal of the match's number. */
internal const val MATCH_NUMBER: String = "match number"

/** The signal that holds while the robot is enabled. */
internal const val ROBOT_ENABLED: String = "robot enabled"

/** The signal that holds while the robot is in autonomous mode. */
internal const val ROBOT_AUTONOMOUS: String = "robot autonomous"

/** The signal that holds while the robot is in test mode. */
internal const val ROBOT_TEST: String = "robot test"

/** The signal of the name of the op mode that runs. */
internal const val OP_MODE: String = "op mode"

/** The signal of the team's name for the battery in the robot. */
internal const val BATTERY_NAME: String = "battery name"
