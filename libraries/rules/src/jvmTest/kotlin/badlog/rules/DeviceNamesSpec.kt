package badlog.rules

import badlog.core.analysis.LogView
import badlog.core.bag.BagParser
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe

class DeviceNamesSpec : FunSpec({
    fun names(vararg devices: NamedDevice) = DeviceNames(devices.toList())

    test("a device is shown with its name, its subsystem, and its name in the log") {
        val names = names(NamedDevice("", 3, "Front left", "Drive"))
        names.deviceText("Phoenix6/TalonFX-3 (rio)") shouldBe "Front left (Drive, TalonFX 3)"
        names.deviceText("TalonFX 3") shouldBe "Front left (Drive, TalonFX 3)"
        names.topicText("Phoenix6/TalonFX-3/StatorCurrent") shouldBe "Phoenix6/TalonFX-3/StatorCurrent (Front left)"
    }

    test("a device without an id on the bus, or with another one, keeps its name") {
        val names = names(NamedDevice("", 3, "Front left", ""), NamedDevice("PDH", 4, "Channel", ""))
        for (text in listOf("Elevator", "Module 3", "PDP/Current 3", "TalonFX 33", "TalonFX 4", "")) names.deviceText(text) shouldBe text
        names.topicText("PDP/Current 3") shouldBe "PDP/Current 3"
    }

    test("among devices with the same id, the type decides, and without it no device is named") {
        val typed = names(NamedDevice("Kraken X60", 3, "Motor", ""), NamedDevice("encoder", 3, "Encoder", ""))
        typed.deviceText("TalonFX 3") shouldBe "Motor (TalonFX 3)"
        typed.deviceText("CANcoder 3 (an absolute encoder)") shouldBe "Encoder (CANcoder 3)"
        names(NamedDevice("", 3, "One", ""), NamedDevice("", 3, "Other", "")).deviceText("TalonFX 3") shouldBe "TalonFX 3"
        names(NamedDevice("", 3, "Any", ""), NamedDevice("SPARK MAX", 3, "Spark", "")).deviceText("Spark 3") shouldBe "Spark (Spark 3)"
    }

    test("findings name devices, also on a page, which has the rules as JSON") {
        val header = """{"topics":[{"name":"Time","unit":"s","attrs":["xaxis"]},{"name":"Phoenix6/TalonFX-3/StatorCurrent","unit":"A"}],"values":[]}"""
        val view = LogView.of(BagParser().apply { accept("$header\nTime,x\n0,1\n1,80\n2,1\n".encodeToByteArray()) }.finish())
        val rule = "[[rule]]\nname = \"A\"\nseverity = \"note\"\neach = { signal = \"stator current\" }\nwhen = \"topic > 60\"\ntext = \"{device}: {topic}\"\n"
        val rules = RulesFile.parse(rule).rules.with(names(NamedDevice("TalonFX", 3, "Front left", "Drive")))
        val page = checkNotNull(RuleSet.fromJson(rules.toJson()))
        for (all in listOf(rules, page)) {
            all.over(view, "a.bag").findings.single().text shouldBe
                "Front left (Drive, TalonFX 3): Phoenix6/TalonFX-3/StatorCurrent (Front left)"
        }
    }
})
