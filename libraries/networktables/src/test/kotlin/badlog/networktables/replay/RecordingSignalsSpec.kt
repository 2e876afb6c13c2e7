package badlog.networktables.replay

import badlog.core.analysis.FlagReading
import badlog.core.analysis.FlagTopic
import badlog.core.analysis.ModeTopics
import badlog.networktables.TopicType
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.shouldBe

private fun ReplayedTopic.texts() = samples.y.map { texts[it.toInt()].decodeToString() }

private val SIGNALS = signalsOf(VARIED_VIEW, "").associateBy { it.name }

class RecordingSignalsSpec : FunSpec({
    test("each topic has its name, type and unit, and each value is a text below Values") {
        SIGNALS.values.map { Triple(it.name, it.type, it.unit) } shouldContainExactly listOf(
            Triple("/Time", TopicType.DOUBLE, "s"),
            Triple("/Arm/Angle", TopicType.DOUBLE, "deg"),
            Triple("/Arm/At Top", TopicType.BOOLEAN, null),
            Triple("/Arm/State", TopicType.STRING, null),
            Triple("/Log", TopicType.STRING, null),
            Triple("/Nothing", TopicType.DOUBLE, "A"),
            Triple("/Values/Match Number", TopicType.STRING, null),
            Triple("/Values/Arm/Größe", TopicType.STRING, null),
        )
    }

    test("a gap of a number is sent once, a gap of a state never") {
        val angle = SIGNALS.getValue("/Arm/Angle").samples
        angle.x.toList() shouldBe listOf(10.0, 10.02, 10.05, 10.1, 10.3)
        angle.y.map { "$it" } shouldBe listOf("1.5", "2.5", "NaN", "2.5", "4.0")
        SIGNALS.getValue("/Arm/State").texts() shouldBe listOf("idle", "rising", "rising", "idle", "idle")
    }

    test("events are at their times") {
        val log = SIGNALS.getValue("/Log")
        log.samples.x.toList() shouldBe listOf(10.02, 10.06, 10.3)
        log.texts() shouldBe listOf("up we go", "again “up”", "done")
    }

    test("values are known from the start") {
        val number = SIGNALS.getValue("/Values/Match Number")
        number.countUntil(-1e300) shouldBe 1
        number.texts() shouldBe listOf("8")
    }

    test("the range is from the first sample to the last") {
        rangeOf(SIGNALS.values.toList()) shouldBe 10.0..10.3
        rangeOf(emptyList()) shouldBe 0.0..0.0
    }

    test("samples are in order even if the log's clock was set back") {
        val view = viewOf("{\"topics\":[{\"name\":\"T\",\"unit\":\"s\",\"attrs\":[\"xaxis\"]}],\"values\":[]}\nT,A\n5,1\n1,2\n3,3\n")
        val samples = signalsOf(view, "").last().samples
        samples.x.toList() shouldBe listOf(1.0, 3.0, 5.0)
        samples.y.toList() shouldBe listOf(2.0, 3.0, 1.0)
    }

    test("names begin with one slash and the prefix, and are unique") {
        val names = TopicNames("badlog/")
        names.nameOf("A/B") shouldBe "/badlog/A/B"
        names.nameOf("//A/B") shouldBe "/badlog/A/B (2)"
        TopicNames("").nameOf("NT:/SmartDashboard/X") shouldBe "/SmartDashboard/X"
    }

    test("type descriptions stay where dashboards look for them") {
        TopicNames("/badlog").nameOf("NT:/.schema/struct:Pose2d") shouldBe "/.schema/struct:Pose2d"
        TopicNames("/badlog").nameOf("/.schema/proto:A") shouldBe "/.schema/proto:A"
    }

    test("the control word shows when the robot was enabled, but not twice") {
        val header = "{\"topics\":[{\"name\":\"T\",\"unit\":\"s\",\"attrs\":[\"xaxis\"]},{\"name\":\"Enabled\"},{\"name\":\"Autonomous\"}],\"values\":[]}\n"
        val rows = "T,Enabled,Autonomous\n0,false,false\n1,true,true\n2,true,false\n3,false,false\n4,false,false\n"
        val modes = ModeTopics(FlagTopic("Enabled", FlagReading.Truth), FlagTopic("Autonomous", FlagReading.Truth))
        val view = viewOf(header + rows).identified(null, modes)
        val word = signalsOf(view, "/badlog").last()
        word.name shouldBe "/FMSInfo/FMSControlData"
        word.typeName shouldBe "int"
        word.samples.x.toList() shouldContainExactly listOf(0.0, 1.0, 2.0, 3.0)
        word.samples.y.toList() shouldContainExactly listOf(32.0, 35.0, 33.0, 32.0)
        val known = LoggedTopic("NT:/FMSInfo/FMSControlData", "int64", "", doubleArrayOf(0.0)) { ByteArray(8) }
        signalsOf(view, "", listOf(known)).map { it.name } shouldContainExactly listOf("/FMSInfo/FMSControlData", "/T", "/Enabled", "/Autonomous")
        signalsOf(viewOf("T,Enabled\n0,false\n"), "").size shouldBe 2
    }

    test("rows without a time are 20 ms apart, and other units of time are converted") {
        fun factor(unit: String) = unitsPerSecond(
            viewOf("{\"topics\":[{\"name\":\"T\",\"unit\":\"$unit\",\"attrs\":[\"xaxis\"]}],\"values\":[]}\nT\n1\n").xAxis,
        )
        unitsPerSecond(viewOf("A,B\n1,2\n").xAxis) shouldBe 50.0
        factor("s") shouldBe 1.0
        factor("ms") shouldBe 1000.0
        factor("furlong") shouldBe 1.0
    }
})
