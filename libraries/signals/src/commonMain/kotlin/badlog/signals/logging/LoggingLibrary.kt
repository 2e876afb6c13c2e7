package badlog.signals.logging

/**
 * A library with which robot programs log, as of the 2026 season.
 *
 * @property title its name.
 */
enum class LoggingLibrary(val title: String) {
    /** WPILib alone: `DataLogManager.start()` writes what is on NetworkTables into a WPILOG. */
    WPILIB("WPILib"),

    /** AdvantageKit, of Littleton Robotics. */
    ADVANTAGEKIT("AdvantageKit"),

    /** Epilogue, a part of WPILib: annotations in a class that is itself `@Logged`. */
    EPILOGUE("Epilogue"),

    /** DogLog. */
    DOGLOG("DogLog"),

    /** The signal logger of CTRE's Phoenix 6. */
    PHOENIX("Phoenix"),

    /** badlog itself. */
    BADLOG("badlog"),
    ;

    /** Returns the line of Java that logs [logged]. */
    internal fun lineFor(logged: LoggedValue): String {
        val topic = logged.topic
        val value = logged.value
        val type = if (logged.isBoolean) "Boolean" else "Double"
        return when (this) {
            WPILIB -> """SmartDashboard.put${if (logged.isBoolean) "Boolean" else "Number"}("$topic", $value);"""
            ADVANTAGEKIT -> """Logger.recordOutput("$topic", $value);"""
            EPILOGUE -> """@Logged(name = "$topic") ${type.lowercase()} ${methodOf(topic)}() { return $value; }"""
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
