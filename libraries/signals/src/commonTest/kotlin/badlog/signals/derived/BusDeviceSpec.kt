package badlog.signals.derived

import badlog.expression.signals.Signal
import badlog.expression.signals.SignalKind
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.shouldBe

class BusDeviceSpec : FunSpec({
    fun devices(vararg names: String) = busDevicesOf(names.map { Signal(it, SignalKind.NUMBER) })

    test("a device of Phoenix is known by its type and id, its quantities by the names of their signals") {
        val device = devices("Phoenix6/TalonFX-3/StatorCurrent", "Phoenix6/TalonFX-3/Velocity", "Phoenix6/TalonFX-3/DeviceTemp").single()
        device.label shouldBe "TalonFX 3"
        device.isMotor shouldBe true
        device.topic(BusSignal.CURRENT) shouldBe "Phoenix6/TalonFX-3/StatorCurrent"
        device.topic(BusSignal.POSITION) shouldBe null
    }

    test("a Spark's topics are named as in REV's logs") {
        val device = devices("REV/Spark-12/APPLIED_OUTPUT", "REV/Spark-12/PRIMARY_ENCODER_VELOCITY", "REV/Spark-12/CURRENT").single()
        device.label shouldBe "Spark 12"
        device.topic(BusSignal.VELOCITY) shouldBe "REV/Spark-12/PRIMARY_ENCODER_VELOCITY"
    }

    test("an encoder is labeled as one") {
        devices("Phoenix6/CANcoder-20/AbsolutePosition").single().label shouldBe "CANcoder 20 (an absolute encoder)"
    }

    test("topics that name a mechanism, or have no id, belong to no device") {
        devices("/Drive/Module0/DriveVelocity", "TalonFX/Velocity", "Elevator/Motor 3/Current", "Spark").shouldBeEmpty()
        busDeviceIn("Phoenix6/TalonFX-3 (rio)/Position") shouldBe "Phoenix6/TalonFX-3 (rio)"
    }
})
