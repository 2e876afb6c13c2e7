package badlog.robots

import badlog.lib.BadLog
import badlog.lib.DataInferMode
import java.util.function.Function
import java.util.function.Supplier

/** Calls the functions in the ways that Kotlin programs do. Half of the test is that this compiles. */
class KotlinRobot(path: String) {
    private val log: BadLog = BadLog.init(path)
    private val maybe: Double? = null
    private val nullable: Supplier<Double?> = Supplier { maybe }
    private val attributes = arrayOf("hide", "join:Arm")

    init {
        BadLog.createTopic("Constructor", BadLog.UNITLESS, Supplier { 1.0 })
        BadLog.createTopic("Lambda", "V", { 2.0 }, "hide")
        BadLog.createTopic("Reference", "m", ::distance, *attributes)
        BadLog.createTopic("Nullable", "m", nullable)
        BadLog.createTopicStr("Text", "ul", Supplier { "text" })
        BadLog.createTopicDouble("Primitive", "A", { 4.0 })
        BadLog.createTopicSubscriber("Subscriber", "ul", DataInferMode.DEFAULT)
        BadLog.createValue("Kotlin", "yes")
        log.setDoubleToStringFunction(Function { "$it" })
        log.finishInitialization()
    }

    fun periodic() {
        BadLog.publish("Subscriber", 5.0)
        log.updateTopics()
        log.log()
    }

    private fun distance(): Double = 3.0
}
