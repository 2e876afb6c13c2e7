package badlog.window.welcome

/**
 * A language that robots log in.
 *
 * @property lines the code, by the place where it belongs. Each line is also in the program in the [guide], which that guide's tests
 * compile and run.
 * @property guide the guide with the rest, in the folder docs.
 */
internal enum class LoggingLanguage(val title: String, val guide: String, val lines: List<Pair<String, String>>) {
    JAVA(
        "Java",
        "robot.md",
        listOf(
            "In the class" to "private final RobotLog log = RobotLog.start();",
            "In the constructor" to """BadLog.createTopicDouble("Arm/Angle", "deg", () -> angle, "join:Arm/Position");""",
            "In robotPeriodic()" to "log.periodic();",
        ),
    ),
    KOTLIN(
        "Kotlin",
        "robot.md",
        listOf(
            "In the class" to "private val log = RobotLog.start(RobotLogOptions().apply { isCompressed = true })",
            "In init" to """BadLog.createTopicDouble("Arm/Angle", "deg", { angle }, "join:Arm/Position")""",
            "In robotPeriodic()" to "log.periodic()",
        ),
    ),
    CPP(
        "C++",
        "robot-cpp.md",
        listOf(
            "In the class" to """badlog::BadLog log = badlog::BadLog::Init(badlog::BadLog::FreePath("/home/lvuser/logs/robot.bag"));""",
            "In the constructor" to
                """
                badlog::BadLog::CreateTopic("Time", "s", [] { return frc::Timer::GetFPGATimestamp().value(); }, {"xaxis", "hide"});
                badlog::BadLog::CreateTopic("Arm/Angle", "deg", [this] { return angle; }, {"join:Arm/Position"});
                log.FinishInitialization();
                """.trimIndent(),
            "In RobotPeriodic()" to "log.UpdateTopics();\nlog.Log();",
        ),
    ),
    PYTHON(
        "Python",
        "python.md",
        listOf(
            "In robotInit()" to
                """
                self.log = BadLog.init("/home/lvuser/logs/match.bag")
                BadLog.create_topic("Time", "s", wpilib.Timer.getFPGATimestamp, "xaxis", "hide")
                BadLog.create_topic("Arm/Angle", "deg", lambda: self.angle, "join:Arm/Position")
                self.log.finish_initialization()
                """.trimIndent(),
            "In robotPeriodic()" to "self.log.update_topics()\nself.log.log()",
        ),
    ),
}
