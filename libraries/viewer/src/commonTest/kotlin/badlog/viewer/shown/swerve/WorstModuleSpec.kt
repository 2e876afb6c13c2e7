package badlog.viewer.shown.swerve

import badlog.core.analysis.LogView
import badlog.core.analysis.Span
import badlog.core.bag.BagParser
import badlog.core.recording.Topic
import badlog.viewer.timedTopic
import badlog.viewer.timedView
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.doubles.plusOrMinus
import io.kotest.matchers.shouldBe
import kotlin.math.PI
import kotlin.math.sin

/** Tests which module is named as the worst, and which healthy ones are not. */
class WorstModuleSpec : FunSpec({
    val times = List(501) { it / 50.0 }
    val degree = PI / 180

    fun line(name: String, late: Double = 0.0, value: (Double) -> Double): Topic = timedTopic(name, *times.map { it + late to value(it) }.toTypedArray())

    /** Returns the errors of four modules with the target [wanted], which they follow [behind] seconds later, and [off] degrees aside. */
    fun errorsOf(
        wanted: (Int, Double) -> Double,
        behind: (Int) -> Double = { 0.06 },
        off: (Int) -> Double = { 0.0 },
        late: (measured: Boolean) -> Double = { 0.0 },
    ): List<ModuleError> {
        val topics = (0..3).flatMap { i ->
            listOf(
                line("Measured[$i]/speed", late(true)) { 2.0 },
                line("Measured[$i]/angle/value", late(true)) { wanted(i, it - behind(i)) + off(i) * degree },
                line("Setpoint[$i]/speed", late(false)) { 2.0 },
                line("Setpoint[$i]/angle/value", late(false)) { wanted(i, it) },
            )
        }
        return SwerveDrive.of(timedView(*topics.toTypedArray()))!!.errors!!.within(Span(0.0, 10.0))
    }

    /** The robot turns to and fro around a place near module 0. That module's target turns four times as far as the others. */
    fun pivot(module: Int, time: Double) = sin(3 * time) * if (module == 0) 1.6 else 0.4

    /** The same, but always in one direction. */
    fun spin(module: Int, time: Double) = time * if (module == 0) 1.6 else 0.4

    test("a healthy module with a target that turns farther than the others is not named") {
        for (wanted in listOf(::pivot, ::spin)) {
            val errors = errorsOf(wanted)
            (errors[0].angle!!.rms > 2.5 * errors[1].angle!!.rms) shouldBe true
            worstModuleText(errors).startsWith("No module stands out: angle errors of") shouldBe true
        }
    }

    test("a module that points 10° aside is named for any target") {
        for (module in listOf(0, 2)) {
            for (wanted in listOf(::pivot, ::spin)) {
                val text = worstModuleText(errorsOf(wanted, behind = { 0.02 }, off = { if (it == module) 10.0 else 0.0 }))
                text.startsWith("Module $module has the largest angle error: ") shouldBe true
            }
        }
    }

    test("a lagging module is named, whether or not the modules turn alike") {
        fun textOf(wanted: (Int, Double) -> Double) = worstModuleText(errorsOf(wanted, behind = { if (it == 0) 0.15 else 0.05 }))
        textOf { _, time -> sin(2 * time) }.startsWith("Module 0 has the largest angle error: ") shouldBe true
        textOf(::pivot).startsWith("Module 0 has the largest angle error: ") shouldBe true
    }

    test("the moment after a target jumps does not count") {
        val jumping = errorsOf({ module, time -> if (module == 1 && time >= 5) PI / 2.2 else 0.0 })
        jumping[1].angle!!.largest shouldBe (0.0 plusOrMinus 1e-9)
        worstModuleText(jumping) shouldBe "The angle errors of the modules are alike: 0.0° RMS."
        val stuck = errorsOf({ module, time -> if (module == 1 && time >= 5) PI / 2.2 else 0.0 }, behind = { if (it == 1) 99.0 else 0.0 })
        worstModuleText(stuck).startsWith("Module 1 has the largest angle error: ") shouldBe true
    }

    test("a log in milliseconds has the errors of the same log in seconds") {
        /**
         * Returns the errors of a bag over x in [unit]; a second has [second] of it. Module 0 lags, and the target of module 1 jumps.
         */
        fun errorsOver(unit: String, second: Double): List<ModuleError> {
            fun wanted(module: Int, time: Double) = pivot(module, time) + if (module == 1 && time >= 5) PI / 3 else 0.0
            val names = (0..2).flatMap { listOf("A[$it]/speed", "A[$it]/angle/value", "Goal[$it]/speed", "Goal[$it]/angle/value") }
            val header = names.joinToString(",", """{"topics":[{"name":"Time","unit":"$unit","attrs":["xaxis"]},""", """],"values":[]}""") {
                """{"name":"$it","unit":"","attrs":[]}"""
            }
            val rows = times.map { time ->
                val cells = (0..2).flatMap { listOf(2.0, wanted(it, time - if (it == 0) 0.15 else 0.05), 2.0, wanted(it, time)) }
                (listOf(time * second) + cells).joinToString(",")
            }
            val parser = BagParser()
            parser.accept((listOf(header, "Time," + names.joinToString(",")) + rows).joinToString("\n", postfix = "\n").encodeToByteArray())
            return SwerveDrive.of(LogView.of(parser.finish()))!!.errors!!.within(Span(0.0, 10 * second))
        }
        val (seconds, millis) = listOf(errorsOver("s", 1.0), errorsOver("ms", 1000.0))
        worstModuleText(millis) shouldBe worstModuleText(seconds)
        for ((one, other) in seconds zip millis) {
            other.angle!!.rms shouldBe (one.angle!!.rms plusOrMinus 1e-6)
            other.target.time shouldBe (one.target.time plusOrMinus 1e-6)
        }
    }

    test("consecutive samples of a loop are one moment, in either order") {
        for (order in listOf(true, false)) {
            val errors = errorsOf({ _, time -> sin(2 * time) }, behind = { 0.0 }, late = { isMeasured -> if (isMeasured == order) 0.0003 else 0.0 })
            for (error in errors) error.angle!!.largest shouldBe (0.0 plusOrMinus 1e-9)
        }
    }

    test("the last values hold to the end of the log") {
        val wheels = (0..2).flatMap { listOf("A[$it]/speed" to 2.0, "A[$it]/angle/value" to 0.1, "Goal[$it]/speed" to 2.0, "Goal[$it]/angle/value" to 0.0) }
        val topics = wheels.map { (name, value) -> timedTopic(name, 0.0 to value) } + timedTopic("Battery", 0.0 to 12.0, 8.0 to 12.0)
        val errors = SwerveDrive.of(timedView(*topics.toTypedArray()))!!.errors!!
        errors.within(Span(6.0, 7.0))[0].angle!!.rms shouldBe (0.1 / degree plusOrMinus 1e-9)
        errors.condition shouldBe "Errors are counted while the target of a module is 0.3 m/s or more, but not in the 0.2 s after its angle jumps. " +
            "The log does not say when the robot was enabled."
    }

    test("one wrong sample of the speed does not shrink all arrows") {
        val wrong = (0..2).flatMap { i ->
            listOf(line("A[$i]/speed") { if (it == 5.0 && i == 1) 1e6 else 3.0 }, line("A[$i]/angle/value") { 0.0 })
        }
        SwerveDrive.of(timedView(*wrong.toTypedArray()))!!.fastest shouldBe 3.0
    }

    test("five and six modules stay within the robot, on its edge") {
        for (count in 3..6) modulePlacesOf(count).maxOf { maxOf(it.ahead, it.left, -it.ahead, -it.left) } shouldBe (1.0 plusOrMinus 1e-9)
    }
})
