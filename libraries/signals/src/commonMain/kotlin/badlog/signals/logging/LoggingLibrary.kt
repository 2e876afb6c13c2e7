package badlog.signals.logging

/**
 * A library with which robot programs log, as of the 2026 season.
 *
 * @property title its name.
 * @property place where its lines belong, as a sentence.
 */
enum class LoggingLibrary(val title: String, val place: String) {
    /** WPILib alone: `DataLogManager.start()` writes the topics of NetworkTables into a WPILOG. */
    WPILIB("WPILib", "In robotPeriodic(), with DataLogManager.start() in the robot's constructor."),

    /** AdvantageKit, of Littleton Robotics. */
    ADVANTAGEKIT("AdvantageKit", "In robotPeriodic(), after Logger.start() in the robot's constructor."),

    /** Epilogue, a part of WPILib: annotations in a class that is itself `@Logged`. */
    EPILOGUE("Epilogue", "In a class that is @Logged, with Epilogue.bind(this) in the robot's constructor."),

    /** DogLog. */
    DOGLOG("DogLog", "In robotPeriodic()."),

    /** The signal logger of CTRE's Phoenix 6. */
    PHOENIX("Phoenix 6", "In robotPeriodic(), with SignalLogger.start() in the robot's constructor."),

    /** badlog itself. */
    BADLOG("badlog", "In the robot's constructor."),
    ;

    /** Returns the line of Java that logs [logged]. */
    internal fun lineFor(logged: LoggedValue): String {
        val topic = logged.topic
        val value = logged.value
        val type = if (logged.isBoolean) "Boolean" else "Double"
        return when (this) {
            WPILIB -> """SmartDashboard.put${if (logged.isBoolean) "Boolean" else "Number"}("$topic", $value);"""
            ADVANTAGEKIT -> """Logger.recordOutput("$topic", $value);"""
            EPILOGUE -> """@Logged(name = "$topic") public ${type.lowercase()} ${methodOf(topic)}() { return $value; }"""
            DOGLOG -> """DogLog.log("$topic", $value);"""
            PHOENIX -> """SignalLogger.write$type("$topic", $value${if (logged.isBoolean) "" else ", \"${logged.unit}\""});"""
            BADLOG -> """BadLog.createTopic$type("$topic", "${logged.unit}", () -> $value);"""
        }
    }
}

/** Returns a name for a method that returns [topic]: `batteryVoltage` for `Battery Voltage`. */
private fun methodOf(topic: String): String = topic.split(' ', '/').joinToString("") { word ->
    word.lowercase().replaceFirstChar { it.uppercase() }
}.replaceFirstChar { it.lowercase() }
