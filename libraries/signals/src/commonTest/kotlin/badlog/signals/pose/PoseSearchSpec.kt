package badlog.signals.pose

import badlog.core.recording.CellCounts
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.doubles.plusOrMinus
import io.kotest.matchers.shouldBe
import kotlin.math.PI

class PoseSearchSpec : FunSpec({
    test("structs of poses and places are poses, a transform is not") {
        val names = poseTopics("Drive/Pose") + poseTopics("Camera/To Robot", "struct:Transform2d") +
            listOf("x", "y").map { poseTopic("Goal/$it", type = "struct:Translation2d") }
        val poses = posesOf(names)
        poses.map { it.name } shouldBe listOf("Drive/Pose", "Goal")
        poses[0].x shouldBe "Drive/Pose/translation/x"
        poses[0].heading shouldBe listOf("Drive/Pose/rotation/value")
        poses[1].heading.shouldBeEmpty()
    }

    test("the heading of a pose in space follows from its quaternion") {
        val parts = listOf("translation/x", "translation/y", "translation/z", "rotation/q/w", "rotation/q/x", "rotation/q/y", "rotation/q/z")
        val pose = posesOf(parts.map { poseTopic("Pose/$it", type = "struct:Pose3d") }).single()
        pose.heading.map { it.substringAfterLast('/') } shouldBe listOf("w", "x", "y", "z")
    }

    test("three numbers of an array are a pose in degrees if its name says so; others are not") {
        fun array(name: String, count: Int) = List(count) { poseTopic("$name[$it]", type = "double[]") }
        val poses = posesOf(array("NT:/SmartDashboard/Field/Robot", 3) + array("Joystick/axes", 3) + array("targetpose_robotspace", 6) + array("NT:/PathPlanner/currentPose", 3))
        poses.map { it.name } shouldBe listOf("NT:/SmartDashboard/Field/Robot", "NT:/PathPlanner/currentPose")
        poses[0].radians shouldBe (PI / 180 plusOrMinus 1e-12)
        // PathPlanner logs radians.
        poses[1].radians shouldBe 1.0
        posesOf(array("limelight/botpose_wpiblue", 7)).single().run { role to heading } shouldBe (PoseRole.SEEN to listOf("limelight/botpose_wpiblue[5]"))
    }

    test("a bag's X and Y in a unit of length are a pose, with the heading of the same name") {
        val topics = listOf("Drive/Pose X" to "m", "Drive/Pose Y" to "m", "Drive/Pose Heading" to "deg", "Target X" to "deg", "Target Y" to "deg", "plan_x" to "in", "plan_y" to "in")
        val (pose, plan) = posesOf(topics.map { (name, unit) -> poseTopic(name, unit) })
        listOf(pose.name, pose.x, pose.y, pose.heading.single()) shouldBe listOf("Drive/Pose", "Drive/Pose X", "Drive/Pose Y", "Drive/Pose Heading")
        pose.role shouldBe PoseRole.DRIVEN
        plan.meters shouldBe 0.0254
        plan.role shouldBe PoseRole.PLANNED
    }

    test("the name shows whether a pose was driven, planned or seen") {
        fun role(name: String) = posesOf(poseTopics(name)).single().role
        listOf("Drive/Pose", "Odometry/Robot", "PoseEstimator/EstimatedPose", "PathPlanner/currentPose").map(::role).distinct() shouldBe listOf(PoseRole.DRIVEN)
        listOf("Drive/TargetPose", "Odometry/TrajectorySetpoint", "PathPlanner/targetPose", "Auto/Desired", "Plan").map(::role).distinct() shouldBe
            listOf(PoseRole.PLANNED)
        listOf("Vision/Estimate", "Camera0/Pose", "TagPoses").map(::role).distinct() shouldBe listOf(PoseRole.SEEN)
    }

    test("the elements of an array name their array") {
        val poses = posesOf(poseTopics("Trajectory[0]") + poseTopics("Trajectory[1]"))
        poses.map { it.list to it.role } shouldBe List(2) { "Trajectory" to PoseRole.PLANNED }
    }

    test("topics without samples are not a pose") {
        posesOf(poseTopics("Pose").map { it.copy(counts = CellCounts(0, 0, 0, 0, 0, 0)) }).shouldBeEmpty()
    }
})
