(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Vectors with integer coordinates. *)
Require Import ZArith Bool.
Open Scope Z_scope.

Record zvec := Zvec { zx : Z; zy : Z; zz : Z }.

Definition zzero := Zvec 0 0 0.
Definition zadd u v := Zvec (zx u + zx v) (zy u + zy v) (zz u + zz v).
Definition zsub u v := Zvec (zx u - zx v) (zy u - zy v) (zz u - zz v).
Definition zneg v := Zvec (- zx v) (- zy v) (- zz v).
Definition zscal k v := Zvec (k * zx v) (k * zy v) (k * zz v).
Definition zdot u v := zx u * zx v + zy u * zy v + zz u * zz v.
Definition zcross u v :=
  Zvec (zy u * zz v - zz u * zy v) (zz u * zx v - zx u * zz v) (zx u * zy v - zy u * zx v).
Definition zdet u v w := zdot u (zcross v w).

Definition is_zero v := (zx v =? 0) && (zy v =? 0) && (zz v =? 0).
Definition same_vector u v := (zx u =? zx v) && (zy u =? zy v) && (zz u =? zz v).

(* v is a positive multiple of u *)
Definition same_sense u v := is_zero (zcross u v) && (0 <? zdot u v).

(* u comes before v in lexicographic order *)
Definition before u v :=
  (zx u <? zx v) || (zx u =? zx v) && ((zy u <? zy v) || (zy u =? zy v) && (zz u <? zz v)).
