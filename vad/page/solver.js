// What JavaScript lacks of the operations of a recorded program (vad/kinematics/recording.py).

const { abs, atan2, sqrt } = Math;

const copysign = (size, sign) => (sign < 0 || 1 / sign < 0 ? -abs(size) : abs(size));

// The same angle within ±180°, of two the one that an even number of turns leads to: the remainder
// of IEEE 754.  No step rounds.  No zero is negative.
const fold = (degrees) => {
  const rest = degrees % 720;
  const size = abs(rest);
  const turn = size >= 540 ? 720 : size > 180 ? 360 : 0;
  return (rest < 0 ? rest + turn : rest - turn) + 0;
};
