package badlog.lib

import badlog.robots.JavaRobot
import badlog.robots.KotlinRobot
import badlog.robots.RecordedScript
import badlog.robots.WhitePaperRobot
import io.kotest.core.annotation.Tags
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import java.io.File

@Tags("InCheck")
class OriginalBytesSpec : FunSpec({
    test("the white paper's example gives the bytes of the original") {
        inFolder { folder ->
            val file = File(folder, "test.bag")
            val robot = WhitePaperRobot()
            robot.robotInit(file.path)
            listOf(0.25, 0.7071067811865476, 1e-5).forEach(robot::periodic)
            file.readText() shouldBe
                """{"topics":[{"unit":"s","name":"Match_Time","attrs":[]},""" +
                """{"unit":"ul","name":"Random_Numbers","attrs":["integrate"]}],""" +
                """"values":[{"name":"Match_Number","value":"8"}]}""" +
                "\nMatch_Time,Random_Numbers\n15.000,0.25000\n14.980,0.70711\n14.960,1.0000e-05\n"
        }
    }

    test("a recorded script of calls writes the same bytes as with the original") {
        inFolder { folder ->
            val file = File(folder, "script.bag")
            RecordedScript.run(file.path, 200)
            val recorded = checkNotNull(OriginalBytesSpec::class.java.getResource("/recorded-script.bag")).readText()
            file.readText() shouldBe recorded
        }
    }

    test("a Java program can use the functions in every way") {
        inFolder { folder ->
            val file = File(folder, "java.bag")
            JavaRobot.run(file.path)
            rowsIn(file) shouldBe List(3) { "1.00,2.00,3.00,3.50,7.00,4.00,5.00,7,encoder,3.50" }
            recordingIn(file).values.last().text shouldBe "DuplicateNameException"
        }
    }

    test("a Kotlin program can use the functions, and its null is a gap") {
        inFolder { folder ->
            val file = File(folder, "kotlin.bag")
            standardErrorOf {
                val robot = KotlinRobot(file.path)
                repeat(2) { robot.periodic() }
            }
            rowsIn(file) shouldBe List(2) { "1.0,2.0,3.0,,text,4.0,5.0" }
        }
    }
})
