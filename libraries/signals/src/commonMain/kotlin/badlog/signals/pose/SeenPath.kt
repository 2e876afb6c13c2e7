package badlog.signals.pose

/**
 * A robot's path by its own estimate, and by a camera.
 *
 * @property seen where the camera saw the robot.
 * @property driven where the robot believed to be.
 */
data class SeenPath(val seen: Pose, val driven: Pose) {
    /** The names of the topics of both paths. */
    val topics: List<String> get() = listOf(seen.x, seen.y, driven.x, driven.y)

    companion object {
        /** Returns the first pair in [poses]; null if there is none. The first place of a list counts. */
        fun of(poses: List<Pose>): SeenPath? {
            fun isSight(pose: Pose) = pose.role == PoseRole.SEEN && pose.meters == 1.0 && !pose.name.contains("target", ignoreCase = true)
            val seen = poses.find(::isSight) ?: return null
            val driven = poses.find { it.role == PoseRole.DRIVEN && it.meters == 1.0 } ?: return null
            return SeenPath(seen, driven)
        }
    }
}
