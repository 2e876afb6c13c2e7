package badlog.core.bag

import badlog.core.json.JsonReader
import badlog.core.recording.Value
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import io.kotest.property.Arb
import io.kotest.property.arbitrary.boolean
import io.kotest.property.arbitrary.double
import io.kotest.property.arbitrary.string
import io.kotest.property.checkAll
import kotlinx.serialization.json.add
import kotlinx.serialization.json.buildJsonObject
import kotlinx.serialization.json.put
import kotlinx.serialization.json.putJsonArray

class HeaderJsonSpec : FunSpec({
    test("keys may be in any order, and missing units and attributes are read as none") {
        readHeader("""{"values":[{"value":"8","name":"Match"}],"topics":[{"attrs":["log"],"name":"Log"},{"name":"A"}]}""") shouldBe
            BagHeader(
                topics = listOf(BagTopic("Log", "ul", listOf("log")), BagTopic("A", "ul", emptyList())),
                values = listOf(BagValue(Value("Match", "8"))),
            )
    }

    test("unknown keys survive being read and written again") {
        val line = """{"topics":[{"name":"A","unit":"V","attrs":[],"color":"red","limits":[1,2.5]}],""" +
            """"values":[{"name":"v","value":"1","source":{"file":null}}],"version":3,"more":{"a":[true,"x"]}}"""
        val header = readHeader(line)!!
        header.unknown shouldBe mapOf("version" to "3", "more" to """{"a":[true,"x"]}""")
        headerText(header) shouldBe line
        readHeader(headerText(header)) shouldBe header
    }

    test("a value that is not a string is kept as its JSON") {
        readHeader("""{"values":[{"name":"Match","value":8},{"name":"On","value":true}]}""")!!.values.map { it.value } shouldBe
            listOf(Value("Match", "8"), Value("On", "true"))
    }

    test("a cut line, or one that is not an object, is not a header") {
        for (line in listOf("", "{", """{"topics":[{"name":"A"""", "[]", "8", "null", "nonsense", "{} {}", "{\"a\":01}", "{\"a\":V}", "{\"a\":1,}", "{a:1}", "{\"a\":\"\\x\"}")) {
            readHeader(line) shouldBe null
        }
    }

    test("numbers keep their digits, whatever the platform's own numbers hold") {
        val line = """{"topics":[],"values":[{"name":"a","value":0.10},{"name":"b","value":12345678901234567890}],"id":1e400}"""
        val header = readHeader(line)!!
        header.values.map { it.value.text } shouldBe listOf("0.10", "12345678901234567890")
        header.unknown shouldBe mapOf("id" to "1e400")
    }

    test("JSON from the library is read as the library reads it") {
        checkAll(Arb.string(0..30), Arb.double(), Arb.boolean()) { text, number, truth ->
            val json = buildJsonObject {
                put("text", text)
                if (number.isFinite()) put("number", number)
                putJsonArray("array") {
                    add(truth)
                    add(text)
                }
            }.toString()
            val members = JsonReader.readObject(json)!!.associate { it.key to it.value }
            members.getValue("text").text shouldBe text
            members["number"]?.json?.toDouble() shouldBe (if (number.isFinite()) number else null)
            members.getValue("array").items!!.map { it.text ?: it.json } shouldBe listOf(truth.toString(), text)
        }
    }

    test("any name, unit and value come back") {
        checkAll(Arb.string(0..30), Arb.string(0..10), Arb.string(0..30)) { name, unit, value ->
            val header = BagHeader(listOf(BagTopic(name, unit, listOf(value))), listOf(BagValue(Value(name, value))))
            readHeader(headerText(header)) shouldBe header
        }
    }

    test("a header in the original's form has its order and escapes, and reads the same") {
        val header = BagHeader(listOf(BagTopic("A/B", "V", listOf("hide"))), listOf(BagValue(Value("a", "\"\\\n\u0001\u0085€°"))))
        val text = headerText(header, asOriginal = true)
        text shouldBe """{"topics":[{"unit":"V","name":"A\/B","attrs":["hide"]}],""" +
            """"values":[{"name":"a","value":"\"\\\n\u0001\u0085\u20AC°"}]}"""
        readHeader(text) shouldBe header
    }

    test("a header is one line, and cannot end a script or a line of JavaScript") {
        val text = headerText(BagHeader(values = listOf(BagValue(Value("a\nb", "\u2028 \u0001")))))
        text.none { it == '\n' || it == '\u2028' || it == '\u0001' } shouldBe true
    }
})
