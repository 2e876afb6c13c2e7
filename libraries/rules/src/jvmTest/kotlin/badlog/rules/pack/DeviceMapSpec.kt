package badlog.rules.pack

import badlog.rules.DeviceNames
import badlog.rules.RulesException
import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.property.Arb
import io.kotest.property.arbitrary.element
import io.kotest.property.arbitrary.list
import io.kotest.property.checkAll

private fun listed(names: DeviceNames) = names.devices.map { listOf(it.type, "${it.id}", it.name, it.subsystem) }

class DeviceMapSpec : FunSpec({
    val same = listOf(listOf("", "3", "Front left", "Drive"), listOf("", "4", "Hood", "Shooter"))

    val forms = listOf(
        """[{"id": 3, "name": "Front left", "subsystem": "Drive"}, {"id": 4, "name": "Hood", "subsystem": "Shooter"}]""",
        """{"devices": [{"CAN ID": 3, "label": "Front left", "Subsystem": "Drive"}, {"can_id": 4, "name": "Hood", "mechanism": "Shooter"}], "team": 1014}""",
        """{"3": {"name": "Front left", "subsystem": "Drive"}, "4": {"name": "Hood", "subsystem": "Shooter"}}""",
        """{"Front left": {"id": 3, "subsystem": "Drive"}, "Hood": {"id": 4, "subsystem": "Shooter"}}""",
        """{"Drive": {"Front left": 3}, "Shooter": {"Hood": 4}}""",
        """{"Drive": [{"id": 3, "name": "Front left"}], "Shooter": [{"id": 4, "name": "Hood"}]}""",
        """{"Drive": {"3": "Front left"}, "Shooter": {"4": "Hood"}}""",
    )
    for (text in forms) {
        test("reads $text") { listed(DeviceMap.parse(text)) shouldBe same }
    }

    test("a type is before the id, or in a member of its own, and other members are ignored") {
        val text = """
            {"SPARK:16": "Indexer",
             "devices": {"CTRE:TalonFX-2": {"name": "Left", "subsystem": "Drive", "control_mode": "velocity"}, "CTRE:Pigeon2-30": {"name": "IMU"}},
             "swerve": {"max_rotation": "180 deg/s", "translate_input": {"controller": 0, "x_axis": 1}},
             "motor_groups": [{"name": "Elevator", "motors": ["CTRE:TalonFX-29"]}]}
        """
        listed(DeviceMap.parse(text)) shouldBe
            listOf(listOf("TalonFX", "2", "Left", "Drive"), listOf("Pigeon2", "30", "IMU", ""), listOf("SPARK", "16", "Indexer", ""))
        listed(DeviceMap.parse("""[{"id": 2, "name": "Left", "type": "CANcoder"}]""")) shouldBe listOf(listOf("CANcoder", "2", "Left", ""))
    }

    test("a text that is not JSON, or lists no device, is refused with the form to write") {
        shouldThrow<RulesException> { DeviceMap.parse("[{") }.message shouldContain "It is not JSON"
        for (text in listOf("{}", "[]", "3", "\"x\"", "[[1]]", "{\"a\": true}")) {
            shouldThrow<RulesException> { DeviceMap.parse(text) }.message shouldContain "It lists no device; write each as {\"id\": 3"
        }
    }

    test("any text is a map, or is refused as a mistake") {
        val pieces = listOf("{", "}", "[", "]", ":", ",", "\"3\"", "\"id\"", "\"name\"", "\"devices\"", "\"TalonFX-2\"", "3", "-1", "1e9", "null", " ")
        checkAll(Arb.list(Arb.element(pieces), 0..14)) { parts ->
            try {
                DeviceMap.parse(parts.joinToString("")).devices.isNotEmpty() shouldBe true
            } catch (e: RulesException) {
                e.message.isNotEmpty() shouldBe true
            }
        }
    }
})
