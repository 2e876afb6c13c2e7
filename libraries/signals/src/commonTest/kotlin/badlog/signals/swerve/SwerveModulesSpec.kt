package badlog.signals.swerve

import badlog.core.recording.Topic
import badlog.expression.signals.Signal
import badlog.expression.signals.SignalKind
import badlog.signals.derived.PartTopic
import badlog.signals.derived.Quantity
import badlog.signals.pose.poseTopic
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.doubles.plusOrMinus
import io.kotest.matchers.shouldBe
import kotlin.math.PI

class SwerveModulesSpec : FunSpec({
    fun states(name: String, count: Int = 4): List<Topic> = List(count) { i -> listOf("speed", "angle/value", "omega").map { poseTopic("$name[$i]/$it", "", "struct:SwerveModuleState[]") } }
        .flatten()

    fun ruled(topics: List<Topic>): List<ModuleTopics> = moduleTopicsOf(topics.map { Signal(it.name, SignalKind.NUMBER, it.unit) }, emptyList())

    test("rules and panel have the same modules of an array, with the optimized targets, in whichever order a log has its topics") {
        val topics = states("Drive/Measured") + states("Drive/Setpoints") + states("Drive/SetpointsOptimized") + states("Drive/Goal", 3)
        for (logged in listOf(topics, topics.reversed(), topics.sortedBy { it.name })) {
            val drive = DriveTopics.of(logged)!!
            drive.measured.labels shouldBe List(4) { "Module $it" }
            drive.measured.angles shouldBe List(4) { "Drive/Measured[$it]/angle/value" }
            drive.target!!.speeds shouldBe List(4) { "Drive/SetpointsOptimized[$it]/speed" }
            drive.withoutTarget shouldBe emptyList()
            val modules = ruled(logged)
            modules.map { it.label } shouldBe drive.measured.labels
            modules.map { it.speed } shouldBe drive.measured.speeds
            modules.map { it.angle } shouldBe drive.measured.angles
            modules.map { it.targetAngle } shouldBe drive.target.angles
        }
    }

    test("rules know modules with names of their own for drive motors") {
        fun part(words: String, name: String, quantity: Quantity, isTarget: Boolean = false) = PartTopic(Signal(name, SignalKind.NUMBER), words.split(' '), quantity, "", isTarget, isAbsolute = false, isMotor = false)
        val parts = listOf("front left", "front right", "back left", "back right").flatMap { corner ->
            listOf(
                part("drive $corner drive", "$corner drive velocity", Quantity.VELOCITY),
                part("drive $corner drive", "$corner drive position", Quantity.POSITION),
                part("drive $corner turn", "$corner turn velocity", Quantity.VELOCITY),
                part("drive $corner", "$corner speed setpoint", Quantity.VELOCITY, isTarget = true),
                part("drive $corner", "$corner angle", Quantity.POSITION),
                part("drive $corner", "$corner angle setpoint", Quantity.POSITION, isTarget = true),
            )
        }
        moduleTopicsOf(emptyList(), parts).last().run { listOf(label, speed, angle, targetSpeed, targetAngle) } shouldBe
            listOf("Back Right", "back right drive velocity", "back right angle", "back right speed setpoint", "back right angle setpoint")

        fun steered(word: String) = moduleTopicsOf(
            emptyList(),
            parts.filter { "angle setpoint" !in it.signal.name } + listOf("front left", "front right", "back left", "back right").map { corner ->
                part("drive $corner turn", "$corner turn $word", Quantity.NONE, isTarget = true)
            },
        ).first().targetAngle
        steered("setpoint") shouldBe "front left turn setpoint"
        // It may be the motor's output.
        steered("command") shouldBe null
    }

    test("two modules, seven, and an array without its first element are no drive for either") {
        for (topics in listOf(states("Drive/Measured", 2), states("Drive/Measured", 7))) {
            DriveTopics.of(topics) shouldBe null
            ruled(topics) shouldBe emptyList()
        }
        swerveModulesOf(states("Drive/Measured", 5).drop(3)) shouldBe emptyList()
    }

    test("targets that lack a module are not used, and the panel says which module has none") {
        val drive = DriveTopics.of(states("Drive/Measured") + states("Drive/Setpoints", 3))!!
        drive.target shouldBe null
        drive.withoutTarget shouldBe listOf("Module 3")
    }

    test("modules with a topic of their own for speed and for angle are known, however their corners are named") {
        fun found(vararg names: String, units: List<String> = listOf("m/s", "deg")): List<SwerveModules> {
            val topics = names.flatMap { name -> listOf(name, name.replace("Speed", "Angle")) }
            return swerveModulesOf(topics.mapIndexed { i, name -> poseTopic(name, units[i % 2]) })
        }

        fun corners(vararg ends: String) = ends.map { "Drive/$it Speed" }.toTypedArray()
        val right = listOf("Front Right", "Rear Right", "Front Left", "Rear Left")
        found(*right.map { "Drive/$it Speed" }.toTypedArray()).single().speeds shouldBe
            listOf("Drive/Front Left Speed", "Drive/Front Right Speed", "Drive/Rear Left Speed", "Drive/Rear Right Speed")
        found(*corners("FL", "FR", "BL", "BR")).single().radians shouldBe (PI / 180 plusOrMinus 1e-12)
        found(*corners("Module0/", "Module1/", "Module2/", "Module3/"), units = listOf("ft/s", "rad")).single().meters shouldBe 0.3048
        found(*corners("Target FL", "Target FR", "Target BL", "Target BR")).single().isTarget shouldBe true
        found(*corners("FrontLeft", "FrontRightt", "BackLeft", "BackRight")).single().isTarget shouldBe false
        found(*corners("FL", "FR", "BR")).single().labels shouldBe listOf("Front Left", "Front Right", "Back Right")
        found(*corners("FL", "BR")) shouldBe emptyList()
        found(*corners("Module0/", "Module1/", "Module3/")) shouldBe emptyList()
        found(*corners("Module0/", "Module1/", "Module2/")).single().labels shouldBe listOf("Module 0", "Module 1", "Module 2")
        found(*corners("FL", "FR", "BL", "BR"), units = listOf("rpm", "deg")) shouldBe emptyList()
        // How far a wheel has turned is not its direction.
        val driven = listOf("FL", "FR", "BL", "BR").flatMap { corner ->
            listOf("Speed" to "m/s", "DrivePosition" to "rad", "TurnPosition" to "rad").map { (what, unit) ->
                poseTopic("Drive/$corner/$what", unit)
            }
        }
        swerveModulesOf(driven).single().angles[0] shouldBe "Drive/FL/TurnPosition"
    }
})
