package badlog.viewer.shown.swerve

import badlog.core.analysis.FlagReading
import badlog.core.analysis.FlagTopic
import badlog.core.analysis.ModeTopics
import badlog.core.analysis.Span
import badlog.core.recording.Topic
import badlog.viewer.timedTopic
import badlog.viewer.timedView
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.doubles.plusOrMinus
import io.kotest.matchers.nulls.shouldBeNull
import io.kotest.matchers.nulls.shouldNotBeNull
import io.kotest.matchers.shouldBe
import kotlin.math.PI
import kotlin.math.sin

class SwerveDriveSpec : FunSpec({
    val times = List(501) { it / 50.0 }

    fun line(name: String, value: (Double) -> Double): Topic = timedTopic(name, *times.map { it to value(it) }.toTypedArray())

    fun states(name: String, count: Int, speed: (Int, Double) -> Double, angle: (Int, Double) -> Double): List<Topic> = List(count) { i ->
        listOf(line("$name[$i]/speed") { speed(i, it) }, line("$name[$i]/angle/value") { angle(i, it) })
    }.flatten()

    fun wanted(time: Double) = sin(time)

    fun driveOf(
        count: Int = 4,
        speed: (Int, Double) -> Double = { _, _ -> 2.0 },
        angle: (Int, Double) -> Double = { _, time -> wanted(time) },
        targetSpeed: Double = 2.0,
        others: List<Topic> = emptyList(),
    ): SwerveDrive {
        val targets = states("Swerve/Setpoints", count, { _, _ -> targetSpeed }, { _, time -> wanted(time) })
        val view = timedView(*(states("Swerve/Measured", count, speed, angle) + targets + others).toTypedArray())
        return SwerveDrive.of(view.identified(null, ModeTopics(FlagTopic("Enabled", FlagReading.Truth), autonomous = null)))!!
    }

    fun SwerveDrive.within(from: Double = 0.0, to: Double = 10.0) = errors!!.within(Span(from, to))

    val degree = PI / 180

    test("a module that points aside is named, with the place of its largest error") {
        val errors = driveOf(angle = { module, time -> wanted(time) + if (module == 2) (if (time in 3.0..3.5) 12.0 else 10.0) * degree else degree })
            .within()
        errors.map { it.label } shouldBe List(4) { "Module $it" }
        errors[0].angle!!.rms shouldBe (1.0 plusOrMinus 1e-9)
        with(errors[2].angle!!) {
            largest shouldBe (12.0 plusOrMinus 1e-9)
            largestAt shouldBe 3.0
            rmsText shouldBe "10.1° RMS"
            largestText shouldBe "largest 12.0°"
        }
        errors[2].speed!!.rms shouldBe (0.0 plusOrMinus 1e-9)
        worstModuleText(errors) shouldBe "Module 2 has the largest angle error: 10.1° RMS, the others 1.0°."
    }

    test("a module that runs backward instead of turning by half a turn follows its target, also after several turns") {
        val drive = driveOf(
            speed = { module, _ -> if (module == 1) -2.0 else 2.0 },
            angle = { module, time -> wanted(time) + listOf(0.0, PI, -2 * PI, 4 * PI)[module] },
        )
        for (error in drive.within()) {
            error.angle!!.largest shouldBe (0.0 plusOrMinus 1e-9)
            error.speed!!.largest shouldBe (0.0 plusOrMinus 1e-9)
        }
        val (backward, ahead) = drive.modules[1].actualAt(1.0)!! to drive.modules[0].actualAt(1.0)!!
        backward.ahead shouldBe (ahead.ahead plusOrMinus 1e-9)
        backward.left shouldBe (ahead.left plusOrMinus 1e-9)
        worstModuleText(drive.within()) shouldBe "The angle errors of the modules are alike: 0.0° RMS."
    }

    test("a permanently reversed module has twice its speed as the error") {
        val drive = driveOf(speed = { module, _ -> if (module == 3) -2.0 else 2.0 })
        drive.within()[3].speed!!.largest shouldBe (-4.0 plusOrMinus 1e-9)
        worstModuleText(drive.within()) shouldBe "Module 3 has the largest speed error: 4.00 m/s RMS, the others 0.00 m/s."
    }

    test("errors without a clearly worse module do not name a module") {
        fun textOf(vararg degrees: Double) = worstModuleText(driveOf(angle = { module, time -> wanted(time) + degrees[module] * degree }).within())
        textOf(1.2, 1.3, 1.6, 1.4) shouldBe "The angle errors of the modules are alike: 1.2 to 1.6° RMS."
        textOf(1.0, 4.0, 5.0, 1.0) shouldBe "No module stands out: angle errors of 1.0 to 5.0° RMS."
    }

    test("only the visible range counts") {
        val drive = driveOf(angle = { module, time -> wanted(time) + if (module == 0 && time < 5) 10 * degree else 0.0 })
        drive.within(to = 4.0)[0].angle!!.rms shouldBe (10.0 plusOrMinus 1e-9)
        drive.within(from = 6.0)[0].angle!!.rms shouldBe (0.0 plusOrMinus 1e-9)
        drive.within(from = 4.0, to = 8.0)[0].angle!!.rms shouldBe (5.0 plusOrMinus 1e-9)
        drive.within(from = 20.0, to = 30.0)[0].angle.shouldBeNull()
        worstModuleText(drive.within(from = 20.0, to = 30.0)) shouldBe "No errors are counted in the visible range."
    }

    test("errors count only while the robot is enabled and drives") {
        val enabled = timedTopic("Enabled", 0.0 to 0.0, 2.0 to 1.0, 4.0 to 0.0)
        val drive = driveOf(angle = { _, time -> wanted(time) + if (time in 2.0..4.0) 3 * degree else 30 * degree }, others = listOf(enabled))
        val errors = drive.within()
        errors[0].angle!!.largest shouldBe (3.0 plusOrMinus 1e-9)
        drive.within(from = 5.0)[0].angle.shouldBeNull()
        worstModuleText(driveOf(targetSpeed = 0.1).within()) shouldBe "No errors are counted in the visible range."
    }

    test("in a log of changes, a stuck angle counts as long as its target continues") {
        val stuck = listOf(timedTopic("Measured[0]/speed", 0.0 to 2.0), timedTopic("Measured[0]/angle/value", 0.0 to 0.0)) +
            states("Measured", 3, { _, _ -> 2.0 }, { _, time -> time }).filterNot { it.name.startsWith("Measured[0]") }
        val targets = states("Target", 3, { _, _ -> 2.0 }, { _, time -> time })
        val errors = SwerveDrive.of(timedView(*(stuck + targets).toTypedArray()))!!.errors!!.within(Span(0.0, 1.0))
        errors[0].angle!!.largest shouldBe (-0.98 * 180 / PI plusOrMinus 1e-6)
        errors[1].angle!!.largest shouldBe (0.0 plusOrMinus 1e-9)
    }

    test("three modules are a drive, but two or seven are not") {
        driveOf(count = 3).within().map { it.label } shouldBe listOf("Module 0", "Module 1", "Module 2")
        driveOf(count = 3).modules.map { it.sign } shouldBe listOf("0", "1", "2")
        for (count in listOf(2, 7)) SwerveDrive.of(timedView(*states("Measured", count, { _, _ -> 1.0 }, { _, _ -> 0.0 }).toTypedArray())).shouldBeNull()
        SwerveDrive.of(timedView(*states("Target", 4, { _, _ -> 1.0 }, { _, _ -> 0.0 }).toTypedArray())).shouldBeNull()
    }

    test("gaps have no errors and no vectors") {
        val drive = driveOf(angle = { module, time -> if (module == 0 && time in 2.0..4.0) Double.NaN else wanted(time) + degree })
        drive.within()[0].angle!!.rms shouldBe (1.0 plusOrMinus 1e-9)
        drive.within(from = 2.5, to = 3.0)[0].angle.shouldBeNull()
        worstModuleText(drive.within(from = 2.5, to = 3.0)) shouldBe "The measured angle of Module 0 is missing in the visible range."
        drive.modules[0].actualAt(3.0).shouldBeNull()
        drive.modules[0].targetAt(3.0).shouldNotBeNull()
        drive.modules[0].actualAt(Double.NaN).shouldBeNull()
    }

    test("without targets, there are actual vectors and no errors, and targets of fewer modules are ignored") {
        val actual = states("Measured", 4, { _, _ -> 3.0 }, { _, _ -> PI / 2 })
        val drive = SwerveDrive.of(timedView(*(actual + states("Target", 3, { _, _ -> 9.0 }, { _, _ -> 0.0 })).toTypedArray()))!!
        drive.errors.shouldBeNull()
        drive.errorsLack shouldBe "This log has no target of Module 3, so the errors are not known."
        SwerveDrive.of(timedView(*actual.toTypedArray()))!!.errorsLack shouldBe
            "This log has no targets of its modules, so their errors are not known."
        drive.modules[0].targetAt(1.0).shouldBeNull()
        drive.modules[0].actualAt(1.0)!!.left shouldBe (3.0 plusOrMinus 1e-9)
        drive.fastest shouldBe 3.0
    }

    test("corners are recognized by their names, in other units, and optimized targets are preferred") {
        fun corners(prefix: String, speed: Double, degrees: Double) = listOf("FL", "FR", "BL", "BR").flatMap { corner ->
            listOf(timedTopic("$prefix/$corner/Speed", 0.0 to speed).copy(unit = "ft/s"), timedTopic("$prefix/$corner/Angle", 0.0 to degrees).copy(unit = "deg"))
        }
        val drive = SwerveDrive.of(timedView(*(corners("Drive", 10.0, 90.0) + corners("Target", 5.0, 0.0) + corners("OptimizedTarget", 10.0, 80.0)).toTypedArray()))!!
        drive.modules.map { it.label to it.sign } shouldBe
            listOf("Front Left" to "FL", "Front Right" to "FR", "Back Left" to "BL", "Back Right" to "BR")
        drive.modules[0].actualAt(0.0)!!.left shouldBe (3.048 plusOrMinus 1e-9)
        drive.modules[0].targetAt(0.0)!!.left shouldBe (3.048 * sin(80 * degree) plusOrMinus 1e-9)
        val lacking = corners("Drive", 10.0, 90.0).filterNot { "BL" in it.name } + corners("Target", 5.0, 0.0)
        with(SwerveDrive.of(timedView(*lacking.toTypedArray()))!!) {
            modules.map { it.sign } shouldBe listOf("FL", "FR", "BR")
            modules.map { it.place.ahead to it.place.left } shouldBe listOf(1.0 to 1.0, 1.0 to -1.0, -1.0 to -1.0)
            errorsLack.shouldBeNull()
        }
    }
})
