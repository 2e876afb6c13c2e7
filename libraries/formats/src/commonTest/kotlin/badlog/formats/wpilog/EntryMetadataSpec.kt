package badlog.formats.wpilog

import badlog.core.bag.parse
import badlog.core.json.quotedJson
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.shouldBe
import io.kotest.property.Arb
import io.kotest.property.arbitrary.list
import io.kotest.property.arbitrary.string
import io.kotest.property.checkAll

private const val TOPIC = "NT:/Telemetry/Arm/Angle"

/** The metadata of an entry for a topic with these [properties], as WPILib writes them. */
private fun withProperties(properties: String) = "{\"properties\":{$properties},\"source\":\"NT\"}"

private fun listJson(texts: List<String>) = texts.joinToString(",", "[", "]", transform = ::quotedJson)

private fun attributesOf(metadata: String, name: String = TOPIC) = parseLog(TestLog().start(1, name, "double", metadata).double(1, 5, 1.0).bytes).topics.single().attributes

class EntryMetadataSpec : FunSpec({
    test("the unit and attributes that a program sets as properties are the topic's") {
        val metadata = withProperties("\"unit\":\"deg\",\"badlog\":[\"differentiate\",\"join:Arm/Position\"],\"retained\":true")
        val topic = parseLog(TestLog().start(1, TOPIC, "double", metadata).double(1, 5, 1.0).bytes).topics.single()
        topic.unit shouldBe "deg"
        topic.attributes shouldContainExactly listOf("differentiate", "join:Arm/Position")
        topic.metadata shouldBe metadata
    }

    test("the last properties count, and one attribute needs no list") {
        val log = TestLog().start(1, TOPIC, "double", withProperties("")).metadata(1, withProperties("\"badlog\":\"hide\"")).double(1, 5, 1.0)
        parseLog(log.bytes).topics.single().attributes shouldContainExactly listOf("hide")
    }

    test("any attributes are read as they were set, and stay when the log is written again") {
        checkAll(Arb.list(Arb.string(0..12), 0..5)) { texts ->
            val metadata = withProperties("\"badlog\":${listJson(texts)}")
            attributesOf(metadata) shouldBe texts
            val before = parseLog(TestLog().start(1, TOPIC, "double", metadata).double(1, 5, 1.0).bytes)
            val after = parseLog(writeLog(before).first).topics.single()
            after.attributes shouldBe texts
            after.metadata shouldBe metadata
        }
    }

    test("attributes that differ from the properties are kept when a log is written, even if there are none") {
        for (attributes in listOf(emptyList(), listOf("zero"))) {
            val metadata = withProperties("\"badlog\":[\"hide\"]")
            val before = parseLog(TestLog().start(1, TOPIC, "double", metadata).double(1, 5, 1.0).bytes)
            val changed = before.copy(topics = before.topics.map { it.copy(attributes = attributes) })
            parseLog(writeLog(changed).first).topics.single().attributes shouldBe attributes
        }
    }

    test("attributes that badlog wrote take precedence over properties, and those over the usual ones of WPILib's entries") {
        attributesOf("{\"attrs\":[\"zero\"],\"properties\":{\"badlog\":[\"hide\"]}}") shouldContainExactly listOf("zero")
        attributesOf(withProperties("\"badlog\":[\"area\"]"), "messages") shouldContainExactly listOf("area")
    }

    test("a program's property does not make a topic the x axis that a bag once had") {
        val metadata = withProperties("\"badlog\":\"xaxis\"")
        parseLog(TestLog().start(1, TOPIC, "double", metadata).double(1, 5, 1.0).bytes).topics.single().wasXAxis shouldBe false
    }

    test("badlog marks a topic's role in a bag, x axis or sparse; texts always have empty cells and no role") {
        val rows = (0 until 30).joinToString("") { "$it,${if (it % 7 == 0) it else ""},${if (it % 7 == 1) "true" else ""},${if (it == 3) "hello" else ""}\n" }
        val bag = parse("{\"topics\":[{\"name\":\"t\",\"attrs\":[\"xaxis\"]},{\"name\":\"n\"},{\"name\":\"on\"},{\"name\":\"said\"}]}\nt,n,on,said\n$rows")
        val topics = parseLog(writeLog(bag).first).topics.associateBy { it.name }
        topics.getValue("t").run { wasXAxis to wasSparse } shouldBe (true to false)
        for (name in listOf("n", "on")) topics.getValue(name).run { wasXAxis to wasSparse } shouldBe (false to true)
        topics.getValue("said").run { wasXAxis to wasSparse } shouldBe (false to false)
    }

    test("a property that is neither a text nor a list of texts is ignored") {
        for (value in listOf("null", "1", "true", "{}", "[]", "[1,null]")) attributesOf(withProperties("\"badlog\":$value")).shouldBeEmpty()
        attributesOf("{\"properties\":7}").shouldBeEmpty()
        attributesOf("{\"properties\":{\"badlog\":").shouldBeEmpty()
    }
})
