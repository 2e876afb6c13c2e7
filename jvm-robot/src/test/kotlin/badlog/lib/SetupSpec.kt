package badlog.lib

import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldBeEmpty
import io.kotest.matchers.string.shouldContain
import java.io.File

class SetupSpec : FunSpec({
    test("a name can be taken once, by a topic or a value") {
        inFolder { folder ->
            logged(folder, {
                BadLog.createTopic("A", "ul", { 1.0 })
                BadLog.createValue("B", "")
                shouldThrow<DuplicateNameException> { BadLog.createValue("A", "") }
                shouldThrow<DuplicateNameException> { BadLog.createTopic("A", "ul", { 1.0 }) }
                shouldThrow<DuplicateNameException> { BadLog.createTopicStr("B", "ul", { "" }) }
                shouldThrow<DuplicateNameException> { BadLog.createTopicSubscriber("B", "ul", DataInferMode.LAST) }
                shouldThrow<DuplicateNameException> { BadLog.createEvents("A") }
                    .message shouldContain "\"A\""
            }) { it.row() }
        }
    }

    test("topics and values are created before the setup is finished, which happens once") {
        inFolder { folder ->
            logged(folder) { log ->
                log.state shouldBe LogState.LOGGING
                shouldThrow<InvalidModeException> { BadLog.createTopic("A", "ul", { 1.0 }) }
                shouldThrow<InvalidModeException> { BadLog.createValue("A", "") }
                shouldThrow<InvalidModeException> { log.finishInitialization() }
            }
            shouldThrow<InvalidModeException> { BadLog.createTopicDouble("A", "ul", { 1.0 }) }
        }
    }

    test("a second log closes the first, and reports that; one after the end of another does not") {
        inFolder { folder ->
            val first = BadLog.init(File(folder, "first.bag").path)
            BadLog.createTopic("A", "ul", { 1.0 })
            first.finishInitialization()
            first.row()
            standardErrorOf {
                val second = BadLog.init(File(folder, "second.bag").path)
                first.state shouldBe LogState.CLOSED
                BadLog.createTopic("A", "ul", { 2.0 })
                second.finishInitialization()
                second.row()
                second.close()
            } shouldContain "the other one was closed"
            rowsIn(File(folder, "first.bag")) shouldBe listOf("1.0000")
            rowsIn(File(folder, "second.bag")) shouldBe listOf("2.0000")
            standardErrorOf { BadLog.init(File(folder, "second.bag").path).close() }.shouldBeEmpty()
        }
    }

    test("an unusual name is accepted, with a warning") {
        inFolder { folder ->
            standardErrorOf { logged(folder, { BadLog.createTopic("a:b", "ul", { 1.0 }) }) {} } shouldContain "':'"
        }
    }

    test("null options count as false") {
        inFolder { folder ->
            BadLog.init(File(folder, "a.bag").path, null, null).use { it.finishInitialization() }
            File(folder, "a.bag").exists() shouldBe true
        }
    }

    test("a null unit, attribute or value does not end the robot's program") {
        inFolder { folder ->
            val file = logged(folder, {
                BadLog.createTopic("A", null, { 1.0 }, "hide", null)
                BadLog.createValue("B", System.getProperty("no such property"))
            }) { it.row() }
            recordingIn(file).run {
                topics[0].unit shouldBe "ul"
                topics[0].attributes shouldBe listOf("hide")
                values.map { it.text } shouldBe listOf("")
            }
        }
    }
})
